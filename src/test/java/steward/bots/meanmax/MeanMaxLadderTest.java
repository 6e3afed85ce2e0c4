package steward.bots.meanmax;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.Bot;
import steward.match.MatchResult;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.replay.Recorded;

/** The bundled bots of Mean Max: without faults, the better one better, and answers that need no memory. */
@Execution(ExecutionMode.CONCURRENT)
class MeanMaxLadderTest {

    /** In 400 games, other seeds, the better one won against two plain ones in all but a few. */
    @Test
    @Tag("slow")
    @Tag("sized")
    void theBetterOneWins() {
        int won = 0;
        int games = TestSize.of(8, 24);
        for (int game = 0; game < games; game++) {
            List<Bot> bots = new ArrayList<>();
            for (int player = 0; player < 3; player++) {
                bots.add(player == game % 3 ? MeanMaxBots.marauder() : MeanMaxBots.gatherer());
            }
            MatchResult result = Recorded.of(TestScenes.open("mean-max"), game, bots).result();
            assertFalse(result.anyFault(), result.toString());
            won += result.winner() == game % 3 ? 1 : 0;
        }
        assertTrue(won >= games * 5 / 6, "won " + won + " of " + games);
    }

    /** A debugger that is fed the frames from some turn on sees the same bot. */
    @Test
    void anAnswerFollowsFromTheSetupAndTheTurnAlone() {
        List<String> lines = new ArrayList<>();
        Recorded.of(TestScenes.open("mean-max"), 2, List.of(MeanMaxBots.marauder(lines::add), MeanMaxBots.gatherer(),
            MeanMaxBots.gatherer()));
        assertTrue(lines.size() > 100);
        for (int k = 1; k + 1 < lines.size(); k += 40) {
            MeanMaxBot fresh = new Marauder();
            fresh.answer(lines.get(0));
            assertEquals(lines.get(k + 1), fresh.answer(lines.get(k)));
        }
    }

    @Test
    void anotherGameIsRefused() {
        assertThrows(IllegalArgumentException.class,
            () -> new Gatherer().answer("{\"type\":\"setup\",\"game\":\"pod-race\"}"));
    }
}
