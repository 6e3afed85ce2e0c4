package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.AlteredBot;
import steward.bot.Bot;
import steward.bot.TestBots;
import steward.game.GameSetup;
import steward.match.SeededBot;
import steward.match.TestScenes;

/** Replays written are read back, verify, and are the same when the match is played again. */
@Execution(ExecutionMode.CONCURRENT)
class RoundTripTest {

    static Stream<Arguments> matches() {
        return TestScenes.SHIPPED.stream().flatMap(scene ->
            Stream.of(1L, 2L, -3L, Long.MIN_VALUE, 0x1234567890ABCDEFL).map(seed -> Arguments.of(scene, seed)));
    }

    @ParameterizedTest
    @MethodSource("matches")
    void aMatchVerifiesToItsLastTurn(String scene, long seed) {
        Recorded match = Recorded.of(scene, seed);

        assertEquals(Recorded.whole(match.result().turns()), match.verify());
        assertEquals(match.result().turns() + 2, match.lines().size());
    }

    @ParameterizedTest
    @CsvSource({"mad-pod-racing", "walled-race"})
    @Tag("slow")
    void sixteenPodsThatRamEachOtherVerify(String scene) {
        GameSetup crowd = TestScenes.changed(scene, "\"perPlayer\": 2", "\"perPlayer\": 8");
        Recorded match = Recorded.of(crowd, 5, 0.9);

        assertEquals(Recorded.whole(match.result().turns()), match.verify());
        long impacts = match.lines().stream().filter(line -> line.contains("\"impacts\":")).count();
        assertTrue(impacts > match.result().turns() / 2, "turns with impacts: " + impacts);
    }

    @ParameterizedTest
    @CsvSource({"mad-pod-racing", "walled-race", "duel"})
    void twoPlaysAreTheSameBytesWithoutTheTimes(String scene) {
        Recorded once = Recorded.of(scene, 11);
        Recorded again = Recorded.of(scene, 11);

        assertEquals(once.withoutTimes(), again.withoutTimes());
        assertNotEquals(once.withoutTimes(), once.text());
        assertEquals(-1, once.withoutTimes().indexOf("Nanos"));
    }

    @Test
    void aPlayerThatNeverAnswersWellAndOneThatStopsAnswering() {
        Bot wrong = TestBots.answering(line -> "half: \uD83D, whole: \uD83D\uDE00, \"quoted\"");
        Bot stops = new AlteredBot(new SeededBot(1, 0), 8, answer -> null);
        Recorded match = Recorded.of(TestScenes.duel(3), 1, List.of(wrong, stops, new SeededBot(2, 0)));

        assertEquals(Recorded.whole(8), match.verify());
        try (ReplayReader reader = Recorded.reader(match.bytes())) {
            for (RecordedTurn turn = reader.next(); turn != null; turn = reader.next()) {
                assertEquals(turn.number() == 1, turn.faults()[0] != null);
                assertEquals(turn.number() == 8 ? "answered null" : null, turn.faults()[1]);
                assertNull(turn.faults()[2]);
            }
            assertEquals("all others are out", reader.ending());
            assertNull(reader.warning());
        }
    }

    /** JSON can contain half a surrogate pair in a message; UTF-8 cannot, so the match would be lost in the writing. */
    @Test
    void aMessageWithHalfACharacterIsKept() {
        Bot bot = TestBots.byTurn(turn -> turn > 2 ? null
            : "{\"pods\":[{\"x\":1,\"y\":2,\"thrust\":3}],\"message\":\"a\\ud83d \\ud83d\\ude00\\u0000\"}");
        Recorded match = Recorded.of(TestScenes.open("duel"), 1, List.of(bot, new SeededBot(2, 0)));

        assertEquals(Recorded.whole(3), match.verify());
        try (ReplayReader reader = Recorded.reader(match.bytes())) {
            assertEquals("a\uFFFD \uD83D\uDE00\0", reader.next().messages()[0]);
        }
    }

    @Test
    void theHeaderIsReadBack() {
        Recorded match = Recorded.of("mad-pod-racing", -9_007_199_254_740_993L);

        try (ReplayReader reader = Recorded.reader(match.bytes())) {
            ReplayHeader header = reader.header();
            assertEquals(-9_007_199_254_740_993L, header.seed());
            assertEquals(List.of("P0", "P1"), header.names());
            assertEquals(List.of("P0", "P1"), header.bots());
            assertEquals("pod-race", header.game());
            assertEquals(Double.POSITIVE_INFINITY, header.timeFactor());
            assertEquals(TestScenes.open("mad-pod-racing").scene(),
                TestScenes.TYPES.open(header.scene(), "header").scene());
        }
    }

    @Test
    void aTurnAtTheImpactLimitIsBoundedInSize() {
        // Three pods wedged between the walls of a narrow box, with a minimum impulse: they collide without end.
        GameSetup wedged = TestScenes.TYPES.open(TestScenes.text("walled-race")
            .replaceAll("(?s)\"bumpers\": \\[.*?]\n  },", "\"bumpers\": []\n  },")
            .replace("\"width\": 16000", "\"width\": 2400").replace("\"height\": 9000", "\"height\": 800")
            .replace("\"players\": 2", "\"players\": 3").replace("\"perPlayer\": 2", "\"perPlayer\": 1")
            .replace("\"minimumImpulse\": 120", "\"minimumImpulse\": 120, \"minimumImpulseAtWalls\": true")
            .replaceAll("(?s)\"maps\": \\[.*],\n    \"jitter\": 30", "\"maps\": [ { \"checkpoints\": "
                + "[ { \"x\": 1200, \"y\": 400 }, { \"x\": 1200, \"y\": 8000 } ] } ]")
            .replace("\"turnsWithoutCheckpoint\": 100", "\"turnsWithoutCheckpoint\": 3"), "wedged");
        Recorded match = Recorded.of(wedged, 1, 0.5);
        int longest = match.lines().stream().mapToInt(String::length).max().orElseThrow();

        assertTrue(match.text().contains("\"impactLimit\":{"), "no turn reached the limit: " + match.lines().get(1));
        assertTrue(match.text().contains("\"impactsInAll\":"));
        assertTrue(longest < 1_000_000, "longest line: " + longest);
        assertEquals(Recorded.whole(match.result().turns()), match.verify());
    }

    @Test
    void turnsAreNumberedFromOne() {
        Recorded match = Recorded.of("duel", 4);

        try (ReplayReader reader = Recorded.reader(match.bytes())) {
            IntStream.rangeClosed(1, match.result().turns())
                .forEach(number -> assertEquals(number, reader.next().number()));
            assertNull(reader.next());
            assertNull(reader.next(), "the end stays the end");
            assertEquals(match.result().ending(), reader.ending());
        }
    }
}
