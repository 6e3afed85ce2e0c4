package steward.game.pokerchiprace;

import java.io.IOException;
import java.util.function.Function;
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
    void everyMatchIsReproducedFromItsSeedToTheLastBit(TestReporter report) throws IOException {
        compare(report, "from the start", match -> new PokerReplay(match).compareWhole());
    }

    @Test
    void everyTurnIsReproducedFromTheStateBeforeIt(TestReporter report) throws IOException {
        compare(report, "turn by turn", match -> new PokerReplay(match).compareTurnByTurn());
    }

    private static void compare(TestReporter report, String how, Function<PokerMatch, Comparison> comparing)
            throws IOException {
        GroundTruth.assertReproduced(report, "poker-chip-race", how, PokerMatch::read, match -> match.turns().size(),
            comparing);
    }
}
