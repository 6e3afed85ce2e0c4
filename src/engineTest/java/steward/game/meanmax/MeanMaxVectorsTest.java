package steward.game.meanmax;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.Comparison;
import steward.game.GroundTruth;

/**
 * Whole matches of the published Mean Max referee: states, impacts, sinkings, ends, faults and the lines sent to bots,
 * from the seed and from every recorded state. Another folder of this form:
 * {@code gradle test --tests '*VectorsTest' -Psteward.vectors=FOLDER}.
 */
class MeanMaxVectorsTest {

    @Test
    void everyMatchIsReproducedFromItsSeedToTheLastBit(TestReporter report) throws IOException {
        compare(report, "from the start", match -> new MeanMaxReplay(match).compareWhole());
    }

    @Test
    void everyTurnIsReproducedFromTheStateBeforeIt(TestReporter report) throws IOException {
        compare(report, "turn by turn", match -> new MeanMaxReplay(match).compareTurnByTurn());
    }

    private static void compare(TestReporter report, String how, Function<MeanMaxMatch, Comparison> comparing)
        throws IOException {
        List<String> differences = new ArrayList<>();
        long values = 0;
        long impacts = 0;
        int turns = 0;
        List<Path> files = GroundTruth.VECTORS.files("mean-max", ".jsonl.gz");
        for (Path file : files) {
            MeanMaxMatch match = MeanMaxMatch.read(file);
            Comparison found = comparing.apply(match);
            values += found.values();
            impacts += found.impacts();
            turns += match.turns().size();
            differences.addAll(found.differences());
        }
        GroundTruth.tell(report, "mean-max, " + how + ": " + files.size() + " matches, " + turns + " turns, " + impacts
            + " impacts, " + values + " values compared, " + differences.size() + " different");

        assertTrue(values > 0, "the folder holds matches");
        assertEquals(List.of(), differences.stream().limit(20).toList());
    }
}
