package steward.league;

import java.io.IOException;
import java.io.InputStream;
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

    /** The hash of a file's bytes, 64 hexadecimal digits. */
    static String of(InputStream in) throws IOException {
        MessageDigest content = Sha256.begin();
        byte[] buffer = new byte[1 << 16];
        for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
            content.update(buffer, 0, count);
        }
        return HexFormat.of().formatHex(content.digest());
    }
}
