package steward.machines.wire;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import steward.files.InputException;
import steward.scene.json.SceneException;

/** Messages, whole and broken. {@code -Dsteward.inputs=100000} tries so many broken ones. */
class WireMessageTest {

    private static final int INPUTS = Integer.getInteger("steward.inputs", 2000);
    private static final long SEED = Long.getLong("steward.seed", 22);

    private static byte[] message() {
        return WireMessage.bytes(new HeaderText().put("type", "result").put("job", "12").put("attempts",
            List.of(new HeaderText().put("size", 3).put("starved", false))), new byte[] {1, 2, 3});
    }

    @Test
    void comesOutAsItWentIn() {
        WireMessage message = WireMessage.read(message(), "m");
        assertEquals("result", message.header().text("type"));
        assertEquals(3, message.header().blocks("attempts").get(0).integer("size", 1, 9));
        assertArrayEquals(new byte[] {1, 2, 3}, message.payload());
        assertEquals("m: job: found \"12\", expected x", message.header().error("job", "\"12\"", "x").getMessage()
            .replaceFirst(":\\d+:\\d+", ""));
    }

    private static void refused(byte[] bytes, String what) {
        InputException problem = assertThrows(InputException.class, () -> WireMessage.read(bytes, "m"));
        assertTrue(problem.getMessage().startsWith("m") && problem.getMessage().contains(what), problem.getMessage());
    }

    /** A bundle that is too large, as a worker says it: bundles are never fetched then. */
    @Test
    void aJobWhoseBotIsTooLargeIsRefusedWithItsSizeAndTheLimit() {
        byte[] job = WireMessage.bytes(new HeaderText().put("type", "job").put("job", "0".repeat(32)).put("seed", "1")
            .put("seats", List.of(new HeaderText().put("name", "mine").put("bundle", "0".repeat(64))
                .put("size", 67_108_865))));
        String said = assertThrows(SceneException.class, () -> GameJob.read(job, "the league", 67_108_864))
            .getMessage();
        assertTrue(said.contains("found 67108865, expected") && said.contains("67108864"), said);
    }

    @Test
    void whatIsNoMessageIsRefused() {
        refused(new byte[0], "expected a message");
        refused(ByteBuffer.allocate(4).putInt(5).array(), "with a header of 5");
        refused(ByteBuffer.allocate(4).putInt(-1).array(), "with a header of -1");
        refused(new byte[WireMessage.LONGEST + 1], "expected a message");
        byte[] deep = "[".repeat(WireMessage.LONGEST_HEADER - 100).getBytes(StandardCharsets.UTF_8);
        refused(ByteBuffer.allocate(4 + deep.length).putInt(deep.length).put(deep).array(), "m");
        byte[] long17 = " ".repeat(WireMessage.LONGEST_HEADER + 1).getBytes(StandardCharsets.UTF_8);
        refused(ByteBuffer.allocate(4 + long17.length).putInt(long17.length).put(long17).array(), "header of 65537");
        refused(new byte[] {0, 0, 0, 2, (byte) 0xC3, 0x28}, "not UTF-8");
    }

    @Test
    void brokenOnesAreRefusedOrRead() {
        SplittableRandom random = new SplittableRandom(SEED);
        int refused = 0;
        for (int k = 0; k < INPUTS; k++) {
            byte[] bytes = message();
            for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
            }
            int number = k;
            try {
                WireMessage message = WireMessage.read(bytes, "m");
                message.header().text("type");
                message.header().blocks("attempts");
                message.header().done();
            } catch (InputException | SceneException expected) {
                refused++;
            } catch (RuntimeException unexpected) {
                throw new AssertionError("seed " + SEED + ", input " + number, unexpected);
            }
        }
        assertTrue(refused > INPUTS / 2, refused + " of " + INPUTS + " refused");
    }
}
