package steward.machines.bundle;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import steward.files.InputException;
import steward.files.Sha256;
import steward.machines.check.GzipText;
import steward.machines.wire.WireMessage;
import steward.scene.json.JsonLimits;

/**
 * A scene that is too long for the first message to a worker, such as one with a CSV file. It is fetched in pieces, as
 * bots are.
 */
public final class LongScene {

    /** Most bytes of a scene: lines of the longest CSV file, each character escaped, and the scene around them. */
    private static final int LONGEST = 2 * JsonLimits.ROW_BYTES + JsonLimits.BYTES;

    private LongScene() { }

    /** Returns the scene, compressed, or {@code null} if it fits into one piece as it is. */
    public static Bundle of(String scene) {
        byte[] bytes = scene.getBytes(StandardCharsets.UTF_8);
        if (bytes.length <= WireMessage.CHUNK) {
            return null;
        }
        byte[] packed = GzipText.compressed(bytes);
        return new Bundle(Sha256.hex(packed), packed);
    }

    /**
     * Returns the scene.
     *
     * @param hash that the bytes have to have
     * @throws InputException if they have another one, or are no such scene
     */
    public static String text(String hash, byte[] packed) {
        if (!Sha256.hex(packed).equals(hash)) {
            throw new InputException("the league's scene: found other bytes, expected those of the hash " + hash);
        }
        try {
            return new String(GzipText.bytes(packed, LONGEST), StandardCharsets.UTF_8);
        } catch (IOException problem) {
            throw new InputException("the league's scene cannot be unpacked: " + problem.getMessage());
        }
    }
}
