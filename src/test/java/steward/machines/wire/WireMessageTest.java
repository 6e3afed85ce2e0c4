package steward.machines.wire;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import steward.files.InputException;
import steward.match.OwnLimits;
import steward.scene.json.SceneException;

/** Messages, whole and broken. {@code -Dsteward.inputs=100000} tries so many broken ones. */
class WireMessageTest {

    private static final int INPUTS = Integer.getInteger("steward.inputs", 2000);
    private static final long SEED = Long.getLong("steward.seed", 22);

    private static byte[] message() {
        return new WorkerWord.Result("12", List.of(new WorkerWord.Played(List.of(new byte[] {1, 2, 3}), List.of(false),
            null, null))).bytes();
    }

    @Test
    void comesOutAsItWentIn() {
        WireMessage message = WireMessage.read(message(), "m");
        assertEquals("result", message.header().text("type"));
        assertEquals(3, message.header().blocks("games").get(0).blocks("attempts").get(0)
            .integer("size", 1, 9));
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
        byte[] job = job(1, new GameJob.Seat("mine", "0".repeat(64), 67_108_865, null));
        String said = assertThrows(SceneException.class, () -> GameJob.read(job, "the league", 67_108_864))
            .getMessage();
        assertTrue(said.contains("found 67108865, expected") && said.contains("67108864"), said);
    }

    private static byte[] job(int games, GameJob.Seat... seats) {
        return new GameJob("0".repeat(32), Collections.nCopies(games, new GameJob.Game(-7, List.of(seats)))).bytes();
    }

    @Test
    void gamesOfAJobNameEachBotOnce() {
        GameJob.Seat one = new GameJob.Seat("one", "1".repeat(64), 9, null);
        GameJob.Seat two = new GameJob.Seat("two", "2".repeat(64), 8, new OwnLimits(60, 500));
        GameJob job = new GameJob("0".repeat(32), List.of(new GameJob.Game(Long.MIN_VALUE, List.of(two, one)),
            new GameJob.Game(7, List.of(one, one))));
        assertEquals(job, GameJob.read(job.bytes(), "m", 9));
        assertEquals(2, WireMessage.read(job.bytes(), "m").header().blocks("bots").size());
        byte[] most = job(GameJob.MOST_GAMES, one, two);
        assertEquals(GameJob.MOST_GAMES, GameJob.read(most, "m", 9).games().size());
        for (byte[] wrong : List.of(job(GameJob.MOST_GAMES + 1, one), job(0), job(1, Collections.nCopies(17, one)
                .toArray(GameJob.Seat[]::new)))) {
            String said = assertThrows(SceneException.class, () -> GameJob.read(wrong, "m", 9)).getMessage();
            assertTrue(said.contains("expected at "), said);
        }
        byte[] unknown = new String(job.bytes(), StandardCharsets.ISO_8859_1).replace("\"bot\":1", "\"bot\":2")
            .getBytes(StandardCharsets.ISO_8859_1);
        String said = assertThrows(SceneException.class, () -> GameJob.read(unknown, "m", 9)).getMessage();
        assertTrue(said.contains("found 2, expected a whole number 0..1"), said);
    }

    @Test
    void aResultHasTheGamesThatWereBegun() {
        WorkerWord.Played once = new WorkerWord.Played(List.of(new byte[] {1}), List.of(false), null, null);
        WorkerWord.Played twice = new WorkerWord.Played(List.of(new byte[] {2, 3}, new byte[] {4}),
            List.of(true, false), "no", null);
        byte[] bytes = new WorkerWord.Result("a", List.of(once, twice)).bytes();
        WorkerWord.Result read = (WorkerWord.Result) WorkerWord.read(bytes, "m", 9);
        assertEquals(2, read.games().size());
        assertArrayEquals(new byte[] {1}, read.games().get(0).transcripts().get(0));
        assertArrayEquals(new byte[] {2, 3}, read.games().get(1).transcripts().get(0));
        assertArrayEquals(new byte[] {4}, read.games().get(1).transcripts().get(1));
        assertEquals(List.of(true, false), read.games().get(1).starved());
        assertEquals("no", read.games().get(1).problem());
        byte[] tooMany = new WorkerWord.Result("a", Collections.nCopies(GameJob.MOST_GAMES + 1, once)).bytes();
        String said = assertThrows(SceneException.class, () -> WorkerWord.read(tooMany, "m", 9)).getMessage();
        assertTrue(said.contains("expected at most 32"), said);
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
                message.header().blocks("games").forEach(game -> game.blocks("attempts"));
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
