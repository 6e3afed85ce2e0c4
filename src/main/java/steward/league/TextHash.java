package steward.league;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import steward.files.Sha256;

/** Hash of a list of texts: the first 128 bits of SHA-256 over the length and bytes of each text. */
final class TextHash {

    private static final int BYTES = 16;

    private final MessageDigest digest = Sha256.begin();

    TextHash add(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        digest.update(ByteBuffer.allocate(Integer.BYTES).putInt(0, bytes.length));
        digest.update(bytes);
        return this;
    }

    TextHash addAll(List<String> texts) {
        add(Integer.toString(texts.size()));
        texts.forEach(this::add);
        return this;
    }

    /** The 16 bytes; call once. */
    byte[] bytes() {
        return Arrays.copyOf(digest.digest(), BYTES);
    }

    /** Returns the hash as 32 hexadecimal digits; call once. */
    String hex() {
        return HexFormat.of().formatHex(bytes());
    }
}
