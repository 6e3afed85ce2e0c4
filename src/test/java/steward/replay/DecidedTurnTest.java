package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.AlteredBot;
import steward.bot.InProcessPlayer;
import steward.bot.TestBots;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TestScenes;
import steward.replay.feed.Feed;
import steward.replay.feed.Takeover;

/**
 * A fault that leaves one player in a Poker Chip Race: the turn is not played, and who comes later is not asked for it.
 * The rules say after which fault that is, so every expected number is that of the fault's turn.
 */
class DecidedTurnTest {

    private static final int SEED = 5;
    private static final String WAIT = "{\"wait\":true}";

    /** Waits with all its chips; in one turn it says nothing that is an answer. */
    private static AlteredBot waiting(int failsIn) {
        return new AlteredBot(TestBots.answering(line -> {
            String own = line.replaceFirst(".*\"own\":\\[([0-9,]*)\\].*", "$1");
            return "{\"chips\":[" + String.join(",", Collections.nCopies(own.split(",").length, WAIT)) + "]}";
        }), failsIn, answer -> "no answer");
    }

    /** Turns that it was sent: all but its setup and its end. */
    private static int asked(AlteredBot bot) {
        return (int) bot.sent().stream().filter(line -> line.startsWith("{\"type\":\"turn\"")).count();
    }

    /** A player per entry: the turn in which it fails, 0 for never. */
    private static List<AlteredBot> bots(String failsIn) {
        return numbers(failsIn).stream().map(DecidedTurnTest::waiting).toList();
    }

    private static List<Integer> numbers(String text) {
        return Arrays.stream(text.split(" ")).map(Integer::valueOf).toList();
    }

    private static Recorded play(List<AlteredBot> bots) {
        return Recorded.of(TestScenes.changed("poker-chip-race", "\"players\": 2", "\"players\": " + bots.size()), SEED,
            bots);
    }

    /** Returns in how many turns there is a command or a fault, for each player. */
    private static List<Integer> recorded(byte[] replay) {
        RecordedMatch match = match(replay);
        return IntStream.range(0, match.header().names().size()).mapToObj(player -> (int) match.turns().stream()
            .filter(turn -> turn.faults()[player] != null || turn.hasCommand(player)).count()).toList();
    }

    private static RecordedMatch match(byte[] replay) {
        return RecordedMatch.read(Recorded.reader(replay));
    }

    /** The first failure of a duel decides it; of three players the second one. */
    @ParameterizedTest
    @CsvSource({"3 0, 3 2", "0 3, 3 3", "3 3, 3 2", "3 4 0, 3 4 3", "4 4 0, 4 4 3", "0 4 4, 4 4 4", "4 0 4, 4 4 4"})
    void whoComesAfterTheDecidingFaultIsNotAsked(String failsIn, String asked) {
        List<AlteredBot> bots = bots(failsIn);
        Recorded game = play(bots);

        assertEquals(numbers(asked), bots.stream().map(DecidedTurnTest::asked).toList());
        assertEquals(numbers(asked), game.result().players().stream().map(MatchResult.PlayerResult::answers).toList());
        assertEquals(Recorded.whole(Collections.max(numbers(asked))), game.verify());
        assertEquals(numbers(asked), recorded(game.bytes()));
    }

    /** Before, all who were in were asked for the turn, and what they said was recorded. */
    @Test
    void anOlderReplayInWhichItWasAskedIsValid() {
        Recorded game = play(bots("3 0"));
        String command = game.lines().get(2).replaceFirst(".*\"commands\":\\[\\[.*?\\],(.*?\\])\\].*", "$1");
        assertTrue(command.startsWith("[{\"wait\":true}"), command);
        byte[] older = Forge.of(game).forge(3, "\\[null,null\\]", "[null," + command + "]").text()
            .getBytes(StandardCharsets.UTF_8);
        assertEquals(Recorded.whole(3), Recorded.verify(older));
        assertEquals(List.of(3, 3), recorded(older));
        assertEquals(3, match(older).lastAsked(1));
    }

    @Test
    void whereABotTakesOverItIsNotAskedEither() {
        Recorded game = play(bots("3 0"));
        for (int from : new int[] {1, 3}) {
            AlteredBot again = waiting(0);
            ByteArrayOutputStream written = new ByteArrayOutputStream();
            Takeover.Outcome outcome = new Takeover(match(game.bytes()), TestScenes.TYPES, 1, Protocol.JSON,
                new InProcessPlayer("P1", again), from, "./new", written).run(turn -> { }, fed -> { });
            assertEquals(3, outcome.turns());
            assertNotNull(outcome.result(), outcome::reason);
            assertEquals(2, asked(again));
            assertEquals(Recorded.whole(3), Recorded.verify(written.toByteArray()));
        }
    }

    @Test
    void whereABotTakesOverFromTheOneThatFailedTheOtherHasNoCommand() {
        Takeover.Outcome outcome = new Takeover(match(play(bots("3 0")).bytes()), TestScenes.TYPES, 0, Protocol.JSON,
            new InProcessPlayer("P0", waiting(0)), 2, "./new", new ByteArrayOutputStream())
            .run(turn -> { }, fed -> { });
        assertEquals("of P1 no command was recorded in turn 3", outcome.reason());
    }

    @Test
    void aBotThatIsFedTheGameIsNotSentTheTurn() {
        AlteredBot again = waiting(0);
        Feed.Ending ending = new Feed(match(play(bots("3 0")).bytes()), TestScenes.TYPES, 1, Protocol.JSON,
            new InProcessPlayer("P1", again)).run(9, turn -> { }, fed -> assertTrue(fed.same()));
        assertEquals(Feed.Ending.WHOLE, ending);
        assertEquals(2, asked(again));
    }

    @Test
    void aCommandThatIsMissingWhereTheTurnIsPlayedIsFound() {
        String without = Forge.of(play(bots("3 4 0")))
            .forge(3, "\"commands\":\\[null,\\[.*?\\],", "\"commands\":[null,null,").text();
        assertEquals("commands[1]", Recorded.verify(without).difference().field());
    }
}
