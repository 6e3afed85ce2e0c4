package steward.replay.feed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.AlteredBot;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.codingame.recording.OfficialGame;
import steward.codingame.recording.RecordingImport;
import steward.match.Protocol;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.replay.RecordedMatch;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.verify.ReplayDifference;

/** A bot is sent what a player of a recorded match was sent, and its answers are compared with the recorded ones. */
class FeedTest {

    private static final long SEED = 4;
    private static final double RAMMING = 0.3;

    /** Returns a bot that {@link Recorded#of(String, long)} lets a player be played by. */
    private static Bot seeded(int player) {
        return new SeededBot(31 * SEED + player, RAMMING);
    }

    private final List<FedTurn> fed = new ArrayList<>();

    private static RecordedMatch match(byte[] replay) {
        try (ReplayReader reader = Recorded.reader(replay)) {
            return RecordedMatch.read(reader);
        }
    }

    private Feed.Ending feed(byte[] replay, int player, Bot bot, int until) {
        fed.clear();
        return new Feed(match(replay), TestScenes.TYPES, player, Protocol.JSON, new InProcessPlayer("fed", bot))
            .run(until, turn -> { }, fed::add);
    }

    private List<Integer> differing() {
        return fed.stream().filter(turn -> !turn.same()).map(FedTurn::number).toList();
    }

    @ParameterizedTest
    @CsvSource({"mad-pod-racing, 0", "mad-pod-racing, 1", "walled-race, 1", "duel, 0"})
    void theSameBotIsSentTheSameAndDoesTheSame(String scene, int player) {
        List<AlteredBot> players = List.of(new AlteredBot(seeded(0), 0, null), new AlteredBot(seeded(1), 0, null));
        Recorded recorded = Recorded.of(TestScenes.open(scene), SEED, List.copyOf(players));
        AlteredBot again = new AlteredBot(seeded(player), 0, null);
        assertEquals(Feed.Ending.WHOLE, feed(recorded.bytes(), player, again, Integer.MAX_VALUE));
        assertEquals(recorded.result().turns(), fed.size());
        assertEquals(List.of(), differing());
        assertEquals(players.get(player).sent(), again.sent());
        assertTrue(again.sent().get(again.sent().size() - 1).startsWith("{\"type\":\"end\""));
    }

    @Test
    void whatDiffersIsNamedWithItsField() {
        Recorded recorded = Recorded.of("mad-pod-racing", SEED);
        Bot other = new AlteredBot(seeded(0), 5, answer -> answer.replaceAll("\"pods\":\\[\\{\"x\":([-0-9.]+),",
            "\"pods\":[{\"x\":1234.5,").replaceFirst("\"y\":[-0-9.]+", "\"y\":-7"));
        assertEquals(Feed.Ending.WHOLE, feed(recorded.bytes(), 0, other, Integer.MAX_VALUE));
        assertEquals(List.of(5), differing());
        List<ReplayDifference> differences = fed.get(4).differences();
        assertEquals("command[0].x command[0].y",
            differences.stream().map(ReplayDifference::field).collect(Collectors.joining(" ")));
        assertEquals("1234.5", differences.get(0).found());
        assertEquals("-7", differences.get(1).found());
    }

    @Test
    void itStopsWhereItIsToldAndSaysNoEnd() {
        Recorded recorded = Recorded.of("duel", SEED);
        AlteredBot bot = new AlteredBot(seeded(1), 0, null);
        assertEquals(Feed.Ending.STOPPED, feed(recorded.bytes(), 1, bot, 7));
        assertEquals(7, fed.size());
        assertEquals(8, bot.sent().size());
        int last = recorded.result().turns();
        AlteredBot all = new AlteredBot(seeded(1), 0, null);
        assertEquals(Feed.Ending.STOPPED, feed(recorded.bytes(), 1, all, last));
        assertEquals(1 + last, all.sent().size(), "no end while it is held");
    }

    @Test
    void anAnswerThatIsNoneDiffersAndFeedingGoesOn() {
        Recorded recorded = Recorded.of("duel", SEED);
        assertEquals(Feed.Ending.WHOLE,
            feed(recorded.bytes(), 0, new AlteredBot(seeded(0), 3, answer -> "nonsense"), Integer.MAX_VALUE));
        assertEquals(List.of(3), differing());
        assertTrue(fed.get(2).fault().endsWith("; received: nonsense"), fed.get(2).fault());
        assertEquals(recorded.result().turns(), fed.size());
    }

    @Test
    void aBotThatIsGoneIsAskedNoMore() {
        Recorded recorded = Recorded.of("duel", SEED);
        Bot gone = new AlteredBot(seeded(0), 3, answer -> null);
        assertEquals(Feed.Ending.BOT_GONE, feed(recorded.bytes(), 0, gone, Integer.MAX_VALUE));
        assertEquals(3, fed.size());
        assertEquals("answered null", fed.get(2).fault());
    }

    @Test
    void aRecordedFailureIsComparedToo() {
        Bot failing = new AlteredBot(seeded(1), 9, answer -> "nonsense");
        Recorded recorded = Recorded.of(TestScenes.open("duel"), SEED, List.of(seeded(0), failing));
        assertEquals(Feed.Ending.WHOLE, feed(recorded.bytes(), 1, seeded(1), Integer.MAX_VALUE));
        assertEquals(List.of(9), differing());
        assertTrue(fed.get(8).recordedFault().endsWith("received: nonsense"), fed.get(8).recordedFault());
        assertNull(fed.get(8).fault());
        assertEquals(9, fed.size());
        AlteredBot again = new AlteredBot(seeded(1), 9, answer -> "nonsense");
        feed(recorded.bytes(), 1, again, Integer.MAX_VALUE);
        assertEquals(List.of(), differing());
        assertEquals(10, again.sent().size(), "a player who failed is told nothing more");
    }

    @Test
    void aCutReplayIsFedUpToTheCut() {
        byte[] whole = Recorded.of("duel", SEED).bytes();
        byte[] half = Arrays.copyOf(whole, whole.length / 2);
        AlteredBot bot = new AlteredBot(seeded(0), 0, null);
        assertEquals(Feed.Ending.WHOLE, feed(half, 0, bot, Integer.MAX_VALUE));
        assertEquals(match(half).turns().size(), fed.size());
        assertFalse(bot.sent().get(bot.sent().size() - 1).contains("\"type\":\"end\""));
        assertThrows(ReplayException.class, () -> match(Arrays.copyOf(whole, 100)));
    }

    @Test
    void aReplayThatTellsAnotherGameIsRefusedAtTheTurn() {
        String text = Recorded.of("duel", SEED).text();
        String changed = text.replaceFirst("(?s)(\"turn\":3,.*?\"hash\":\")[0-9a-f]{16}", "$10123456789abcdef");
        ReplayException problem = assertThrows(ReplayException.class,
            () -> feed(changed.getBytes(StandardCharsets.UTF_8), 0, seeded(0), Integer.MAX_VALUE));
        assertTrue(problem.getMessage().startsWith("r.jsonl:4: turn 3 differs when it is played again"),
            problem.getMessage());
    }

    /** The bots of the official game spoke JSON; the recording has lines. The commands are the same. */
    @Test
    void anImportedMatchIsFedInEitherProtocol() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        RecordingImport.of(OfficialGame.play(12).json(), "game.json", TestScenes.TYPES, null).write(replay);
        feed(replay.toByteArray(), 1, new SeededBot(13, 0.2), Integer.MAX_VALUE);
        assertTrue(fed.size() > 50, () -> fed.size() + " turns");
        assertEquals(List.of(), differing());
        InProcessPlayer lines = new InProcessPlayer("lines", new LineBot());
        fed.clear();
        new Feed(match(replay.toByteArray()), TestScenes.TYPES, 0, Protocol.CODINGAME, lines)
            .run(20, turn -> { }, fed::add);
        assertEquals(20, fed.size());
        assertTrue(fed.stream().allMatch(turn -> turn.fault() == null), fed::toString);
    }

    /** Answers each turn with two lines. */
    private static final class LineBot implements Bot {

        @Override
        public void setup(String line) {
            assertTrue(line.startsWith("3\n"), line);
        }

        @Override
        public String turn(String line) {
            assertEquals(4, line.lines().count());
            return "1 2 3\n4 5 SHIELD";
        }
    }
}
