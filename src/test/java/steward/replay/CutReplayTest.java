package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.Bot;
import steward.bot.TestBots;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.replay.verify.Verification;

/** A replay whose writer was killed: whatever is left of it is read and verified up to the cut. */
@Execution(ExecutionMode.CONCURRENT)
class CutReplayTest {

    /** Seven turns with a message beyond ASCII, rammed pods and a fault. */
    private static Recorded small() {
        Bot talker = TestBots.byTurn(turn -> turn == 7 ? "\u00e4\uD83D\uDE00"
            : "{\"pods\":[{\"x\":5500.5,\"y\":3000,\"boost\":true}],\"message\":\"\u00e4\uD83D\uDE00\"}");
        return Recorded.of(TestScenes.open("duel"), 3, List.of(talker, new SeededBot(3, 1)));
    }

    /** Cuts after every so many bytes, and at every byte beside a line end. */
    @Test
    @Tag("sized")
    void cutAtEveryEndOfALineAndSomeBytesBetween() {
        int step = TestSize.of(17, 1);
        Recorded match = small();
        byte[] replay = match.bytes();
        assertEquals(Recorded.whole(7), match.verify());
        assertTrue(match.text().contains("\"impacts\""));
        int turnsAtCut = 0;
        int resultAt = match.text().substring(0, match.text().indexOf("{\"type\":\"result\""))
            .getBytes(StandardCharsets.UTF_8).length;
        for (int cut = 1; cut <= replay.length; cut++) {
            boolean besideEnd = replay[cut - 1] == '\n' || cut + 1 >= replay.length || replay[cut] == '\n'
                || replay[cut + 1] == '\n';
            if (cut % step != 0 && !besideEnd) {
                continue;
            }
            Verification verification = Recorded.verify(Arrays.copyOf(replay, cut));
            // A line counts as soon as its closing brace is there; the header is line 0.
            boolean closes = cut < replay.length && replay[cut] == '\n';
            if (closes && cut < resultAt && cut > match.lines().get(0).length()) {
                turnsAtCut++;
            }
            int at = cut;
            int turns = turnsAtCut;
            assertNull(verification.difference(), () -> "cut at " + at + ": " + verification.difference());
            assertEquals(turns, verification.turns(), () -> "cut at " + at);
            if (cut < replay.length - 1) {
                assertTrue(verification.warning().startsWith("r.jsonl: cut off "), verification.warning());
            } else {
                assertNull(verification.warning(), "only the last line end is missing");
            }
        }
        assertEquals(7, turnsAtCut);
    }

    @Test
    void theWarningSaysWhere() {
        Recorded match = small();
        byte[] replay = match.bytes();
        int header = match.lines().get(0).length();

        assertEquals("r.jsonl: cut off within the header: there is no turn to look at",
            Recorded.verify(Arrays.copyOf(replay, 1)).warning());
        assertEquals("r.jsonl: cut off within the header: there is no turn to look at",
            Recorded.verify(Arrays.copyOf(replay, header - 1)).warning());
        assertEquals("r.jsonl: cut off before the first turn: there is only the header",
            Recorded.verify(Arrays.copyOf(replay, header)).warning());
        assertEquals("r.jsonl: cut off within the first turn: only the header is whole",
            Recorded.verify(Arrays.copyOf(replay, header + 2)).warning());
        assertEquals("r.jsonl: cut off within the line after turn 7",
            Recorded.verify(Arrays.copyOf(replay, replay.length - 5)).warning());
    }

    /** A line in the middle is gone: all others are read. */
    @Test
    void missingTurnsAreNamed() {
        List<String> lines = new ArrayList<>(small().lines());
        lines.remove(3);
        byte[] replay = (String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8);
        try (ReplayReader reader = Recorded.reader(replay)) {
            int turns = 0;
            while (reader.next() != null) {
                turns++;
            }
            assertEquals(6, turns);
            assertEquals("r.jsonl:4: turn: found 4, expected 3: turns are missing or out of order", reader.warning());
        }
    }

    @Test
    void aFileThatIsCutWithinTheHeaderHasNone() {
        try (ReplayReader reader = Recorded.reader(Arrays.copyOf(small().bytes(), 100))) {
            assertNull(reader.header());
            assertNull(reader.next());
            assertNull(reader.ending());
        }
    }

    @Test
    void anEmptyFileIsNoReplay() {
        byte[] nothing = {};
        ReplayException refusal = assertThrows(ReplayException.class, () -> Recorded.verify(nothing));

        assertEquals("r.jsonl: found an empty file, expected a replay", refusal.getMessage());
    }

    /** Streams give what they have, not what was asked for. */
    @ParameterizedTest
    @ValueSource(ints = {1, 7, 4096})
    void readInPieces(int piece) {
        Recorded match = small();
        InputStream slow = new ByteArrayInputStream(match.bytes()) {
            @Override
            public synchronized int read(byte[] into, int from, int count) {
                return super.read(into, from, Math.min(piece, count));
            }
        };
        try (ReplayReader reader = new ReplayReader(slow, "slow")) {
            assertEquals(Recorded.whole(7), Verification.of(reader, TestScenes.TYPES));
        }
    }
}
