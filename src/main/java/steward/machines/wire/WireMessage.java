package steward.machines.wire;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import steward.files.InputException;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/**
 * A message on the wire: the length of the header in four bytes, the header as a JSON object in UTF-8, then any bytes.
 *
 * @param header  to be read field by field, and {@link Block#done}
 * @param payload not copied
 */
public record WireMessage(Block header, byte[] payload) {

    /** How long a header may be, in bytes. */
    public static final int LONGEST_HEADER = 1 << 16;
    /** How long a message may be, in bytes: two compressed replays of the longest matches. */
    public static final int LONGEST = 16 << 20;
    /** Bytes of a large file that one message has. */
    public static final int CHUNK = 1 << 18;

    /** The bytes of a message. */
    public static byte[] bytes(HeaderText header, byte[]... payloads) {
        byte[] text = header.text().getBytes(StandardCharsets.UTF_8);
        int size = Integer.BYTES + text.length + Arrays.stream(payloads).mapToInt(part -> part.length).sum();
        ByteBuffer bytes = ByteBuffer.allocate(size).putInt(text.length).put(text);
        for (byte[] payload : payloads) {
            bytes.put(payload);
        }
        return bytes.array();
    }

    /**
     * Reads a message.
     *
     * @param source names it in errors
     * @throws InputException if it is none
     */
    public static WireMessage read(byte[] bytes, String source) {
        ByteBuffer buffer = ByteBuffer.wrap(bytes);
        int length = bytes.length < Integer.BYTES ? -1 : buffer.getInt();
        if (bytes.length > LONGEST || length < 0 || length > Math.min(LONGEST_HEADER, buffer.remaining())) {
            throw new InputException(source + ": found " + bytes.length + " bytes with a header of " + length
                + ", expected a message");
        }
        try {
            String text = Utf8Text.decode(Arrays.copyOfRange(bytes, Integer.BYTES, Integer.BYTES + length), source,
                "a message");
            return new WireMessage(new Block(source, "", JsonTree.read(text, source, "a message")),
                Arrays.copyOfRange(bytes, Integer.BYTES + length, bytes.length));
        } catch (NotUtf8Exception | SceneException problem) {
            throw new InputException(problem.getMessage());
        }
    }
}
