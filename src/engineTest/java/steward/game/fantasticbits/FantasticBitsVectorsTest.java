package steward.game.fantasticbits;

import java.io.IOException;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.Comparison;
import steward.game.GroundTruth;

/**
 * Whole matches of the published Fantastic Bits referee: states, impacts, captures, goals, ends, faults and the lines
 * sent to bots, from the seed and from every recorded state. Another folder of this form:
 * {@code gradle test --tests '*VectorsTest' -Psteward.vectors=FOLDER}.
 */
@Execution(ExecutionMode.CONCURRENT)
class FantasticBitsVectorsTest {

    @Test
    void everyMatchIsReproducedFromItsSeedToTheLastBit(TestReporter report) throws IOException {
        compare(report, "from the start", match -> new FantasticBitsReplay(match).compareWhole());
    }

    @Test
    void everyTurnIsReproducedFromTheStateBeforeIt(TestReporter report) throws IOException {
        compare(report, "turn by turn", match -> new FantasticBitsReplay(match).compareTurnByTurn());
    }

    private static void compare(TestReporter report, String how, Function<FantasticBitsMatch, Comparison> comparing)
            throws IOException {
        GroundTruth.assertReproduced(report, "fantastic-bits", how, FantasticBitsMatch::read,
            match -> match.turns().size(), comparing);
    }
}
