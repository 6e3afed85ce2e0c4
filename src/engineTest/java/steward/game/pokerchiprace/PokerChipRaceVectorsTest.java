package steward.game.pokerchiprace;

import java.io.IOException;
import java.util.function.Function;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.Comparison;
import steward.game.GroundTruth;

/**
 * Whole matches of the published Poker Chip Race referee: starts, states, impacts, ends, faults and the lines sent to
 * bots, from the seed and from every recorded state. Another folder of this form:
 * {@code gradle test --tests '*VectorsTest' -Psteward.vectors=FOLDER}.
 */
@Execution(ExecutionMode.CONCURRENT)
class PokerChipRaceVectorsTest {

    @Test
    void matchesAreReproducedFromTheirSeedsToTheLastBit(TestReporter report) throws IOException {
        compareWhole(report, false);
    }

    @Test
    @Tag("campaign")
    void everyMatchIsReproducedFromItsSeedToTheLastBit(TestReporter report) throws IOException {
        compareWhole(report, true);
    }

    private static void compareWhole(TestReporter report, boolean all) throws IOException {
        compare(report, all, "from the start", match -> new PokerReplay(match).compareWhole());
    }

    @Test
    void turnsAreReproducedFromTheStatesBeforeThem(TestReporter report) throws IOException {
        compareTurns(report, false);
    }

    @Test
    @Tag("campaign")
    void everyTurnIsReproducedFromTheStateBeforeIt(TestReporter report) throws IOException {
        compareTurns(report, true);
    }

    private static void compareTurns(TestReporter report, boolean all) throws IOException {
        compare(report, all, "turn by turn", match -> new PokerReplay(match).compareTurnByTurn());
    }

    private static void compare(TestReporter report, boolean all, String how,
                                Function<PokerMatch, Comparison> comparing) throws IOException {
        GroundTruth.assertReproduced(report, all, "poker-chip-race", how, PokerMatch::read,
            match -> match.turns().size(), comparing);
    }
}
