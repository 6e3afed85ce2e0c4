package steward.game.podrace.vectors;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.podrace.simulator.CppHeader;

/**
 * Whole matches of the published referee with correctly rounded sine and cosine: states, impacts, paths, ends, faults
 * and the lines sent to bots, from the start and from every state that was set by hand. Another folder of this form, or
 * one with a folder per game: {@code gradle test --tests '*VectorsTest' -Psteward.vectors=FOLDER}.
 */
@Execution(ExecutionMode.CONCURRENT)
class PodRaceVectorsTest {

    private static List<Path> files() throws IOException {
        return GroundTruth.VECTORS.files("pod-race", ".jsonl.gz");
    }

    private static List<Path> everyThirdFile() throws IOException {
        List<Path> files = files();
        return IntStream.range(0, files.size()).filter(k -> k % 3 == 0).mapToObj(files::get).toList();
    }

    @Test
    void everyMatchOfTheRefereeIsReproducedToTheLastBit(TestReporter report) throws IOException {
        List<String> differences = new ArrayList<>();
        long values = 0;
        long impacts = 0;
        int turns = 0;
        List<Path> files = files();
        for (Path file : files) {
            VectorMatch match = VectorMatch.read(file);
            Comparison found = new VectorReplay(match).compare();
            report.publishEntry(match.name() + ": " + match.turns().size() + " turns, " + found.values()
                + " values compared, " + found.differences().size() + " different");
            values += found.values();
            impacts += found.impacts();
            turns += match.turns().size();
            differences.addAll(found.differences());
        }
        GroundTruth.tell(report, "pod-race: " + files.size() + " matches, " + turns + " turns, " + impacts
            + " impacts, " + values
            + " values compared, " + differences.size() + " different");

        assertTrue(values > 0, "the folder holds matches");
        assertEquals(List.of(), differences.stream().limit(20).toList());
    }

    @Test
    @Tag("process")
    void theSimulatorPlaysTheSameTurns(TestReporter report) throws IOException {
        theSimulatorPlays(report, everyThirdFile());
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void theSimulatorPlaysAllTurns(TestReporter report) throws IOException {
        theSimulatorPlays(report, files());
    }

    private static void theSimulatorPlays(TestReporter report, List<Path> files) throws IOException {
        List<String> differences = new ArrayList<>();
        long values = 0;
        int turns = 0;
        for (Path file : files) {
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
    void theHeaderForBotsPlaysTheSameTurns(TestReporter report) throws IOException, InterruptedException {
        theHeaderPlaysTheSameTurns(new CppHeader(report, false), everyThirdFile());
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void byEveryFlagTheHeaderForBotsPlaysTheSameTurns(TestReporter report) throws IOException, InterruptedException {
        theHeaderPlaysTheSameTurns(new CppHeader(report, true), files());
    }

    private static void theHeaderPlaysTheSameTurns(CppHeader started, List<Path> files) throws IOException,
            InterruptedException {
        try (CppHeader header = started) {
            for (Path file : files) {
                Comparison found = new SimulatedVectors(VectorMatch.read(file), header).compare();
                assertEquals(List.of(), found.differences());
            }
            header.assertNothingDiffers();
        }
    }
}
