package steward.game.podrace.vectors;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.VectorMatch;
import steward.game.podrace.simulator.CppHeader;
import steward.match.TestSize;

/**
 * Matches of the published referee, played by the simulator and by the header for bots. Another folder of this form:
 * {@code gradle test --tests '*VectorsTest' -Psteward.vectors=FOLDER}.
 */
@Execution(ExecutionMode.CONCURRENT)
class PodRaceVectorsTest {

    private static List<Path> files(boolean all) throws IOException {
        return all ? GroundTruth.VECTORS.files("pod-race", ".jsonl.gz") : GroundTruth.matches("pod-race");
    }

    @Test
    @Tag("process")
    @Tag("sized")
    void theSimulatorPlaysTheSameTurns(TestReporter report) throws IOException {
        compareSimulator(report, TestSize.isWhole());
    }

    private static void compareSimulator(TestReporter report, boolean all) throws IOException {
        List<String> differences = new ArrayList<>();
        long values = 0;
        int turns = 0;
        for (Path file : files(all)) {
            VectorMatch match = VectorMatch.read(file);
            SimulatedVectors simulated = new SimulatedVectors(match, null);
            Comparison found = simulated.compare();
            values += found.values();
            turns += simulated.turns();
            differences.addAll(found.differences());
        }
        GroundTruth.tell(report, "pod-race, simulator: " + turns + " turns, " + values
            + " values compared, " + differences.size()
            + " different");

        assertTrue(turns > 0, "the folder holds turns without faults");
        assertEquals(List.of(), differences.stream().limit(20).toList());
    }

    @Test
    @Tag("process")
    @Tag("sized")
    void theHeaderForBotsPlaysTheSameTurns(TestReporter report) throws IOException, InterruptedException {
        theHeaderPlaysTheSameTurns(new CppHeader(report, TestSize.isWhole()), TestSize.isWhole());
    }

    private static void theHeaderPlaysTheSameTurns(CppHeader started, boolean all)
            throws IOException, InterruptedException {
        try (CppHeader header = started) {
            for (Path file : files(all)) {
                Comparison found = new SimulatedVectors(VectorMatch.read(file), header).compare();
                assertEquals(List.of(), found.differences());
            }
            header.assertNothingDiffers();
        }
    }
}
