package steward.replay.sign;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.HexFormat;
import steward.files.Sha256;

/**
 * Digest of the signed part of a replay: all its lines up to the result, each without its field {@code times}, with its
 * line end. The SHA-256 is computed line by line, so nothing is kept in memory. The signature is Ed25519 over one line
 * of text that names its purpose, so that it is valid for nothing else (domain separation):
 *
 * <pre>steward replay sha256:0123...64 hexadecimal digits...cdef</pre>
 *
 * <p>and a line feed. If the line of the signature has a field {@code isolation}, a blank, {@code isolation sha256:}
 * and the digest of that field's text stand before the line feed. With the tools of any Unix, with the public key in
 * {@code mine.pub}:
 *
 * <pre>
 * sed -e '$d' match.jsonl | sed -e 's/,"times":{[^}]*}}$/}/' | sha256sum       (the digits of the text)
 * tail -1 match.jsonl | grep -o '[A-Za-z0-9+/]\{86\}==' | base64 -d &gt; signature
 * openssl pkeyutl -verify -rawin -pubin -inkey mine.pub -in text -sigfile signature
 * </pre>
 *
 * <p>The signer's public key is in the header, and so is signed itself.
 */
public final class LinesDigest {

    private static final byte[] END = {'}', '\n'};

    private final MessageDigest sha256 = Sha256.begin();

    /** Adds a line, without {@code times} and the closing brace. */
    public void add(byte[] line, int length) {
        sha256.update(line, 0, length);
        sha256.update(END, 0, END.length);
    }

    /**
     * The text that is signed, of all lines added; call once.
     *
     * @param isolation how bots were kept apart, of which a digest is signed as well; or {@code null}
     */
    public byte[] message(String isolation) {
        String text = "steward replay sha256:" + HexFormat.of().formatHex(sha256.digest());
        if (isolation != null) {
            text += " isolation sha256:" + Sha256.hex(isolation.getBytes(StandardCharsets.UTF_8));
        }
        return (text + "\n").getBytes(StandardCharsets.US_ASCII);
    }
}
