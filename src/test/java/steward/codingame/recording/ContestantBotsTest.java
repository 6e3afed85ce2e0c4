package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.GameSetup;
import steward.match.Seat;
import steward.match.TestScenes;
import steward.match.TimeControl;

/**
 * Bots as contestants write them, in three languages, each in matches against a bot that speaks JSON: the upper leagues
 * with two pods, the lower ones with one, from both sides.
 */
@Execution(ExecutionMode.CONCURRENT)
@Tag("process")
@Timeout(120)
class ContestantBotsTest {

    /** Each side once, each in another scene. */
    private static final int FEW = 2;
    private static final int MANY = 20;
    private static final List<String> SCENES = List.of("duel", "mad-pod-racing-silver", "mad-pod-racing", "duel");

    @TempDir
    private Path folder;

    @Test
    void writtenInCpp(TestReporter report) throws IOException, InterruptedException {
        cpp(report, FEW);
    }

    @Test
    void writtenInJava(TestReporter report) throws IOException {
        java(report, FEW);
    }

    @Test
    void writtenInPython(TestReporter report) throws IOException, InterruptedException {
        python(report, FEW);
    }

    @Test
    @Tag("campaign")
    void writtenInCppItPlaysManyMatches(TestReporter report) throws IOException, InterruptedException {
        cpp(report, MANY);
    }

    @Test
    @Tag("campaign")
    void writtenInJavaItPlaysManyMatches(TestReporter report) throws IOException {
        java(report, MANY);
    }

    @Test
    @Tag("campaign")
    void writtenInPythonItPlaysManyMatches(TestReporter report) throws IOException, InterruptedException {
        python(report, MANY);
    }

    private void cpp(TestReporter report, int matches) throws IOException, InterruptedException {
        assumeTrue(onPath("g++"), "skipped: there is no g++ on the PATH");
        Path program = folder.resolve("pilot");
        assertEquals(0, run("g++", "-O1", "-o", program.toString(), source("pilot.cpp").toString()));
        play(report, "pilot.cpp", matches, List.of(program.toString()));
    }

    private void java(TestReporter report, int matches) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this Java has no compiler");
        assertEquals(0, compiler.run(null, null, null, "-d", folder.toString(), source("Pilot.java").toString()));
        play(report, "Pilot.java", matches, List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", folder.toString(), "Player"));
    }

    private void python(TestReporter report, int matches) throws IOException, InterruptedException {
        assumeTrue(onPath("python3"), "skipped: there is no python3 on the PATH");
        assumeTrue(run("python3", "-c", "import math, sys") == 0, "skipped: python3 does not run");
        play(report, "pilot.py", matches, List.of("python3", source("pilot.py").toString()));
    }

    private static void play(TestReporter report, String name, int matches, List<String> command) {
        int wins = 0;
        int turns = 0;
        for (int match = 0; match < matches; match++) {
            GameSetup setup = TestScenes.open(SCENES.get((match + match / 4) % SCENES.size()));
            int side = match % 2;
            Seat bot = TextMatches.program(name, command);
            Seat[] seats = side == 0 ? new Seat[] {bot, TextMatches.racer()}
                : new Seat[] {TextMatches.racer(), bot};
            TextMatches played = TextMatches.play(setup, match, TimeControl.UNLIMITED, seats);
            for (int player = 0; player < seats.length; player++) {
                assertNull(played.player(player).fault(), setup.scene().name() + ", seed " + match);
                assertEquals(0, played.player(player).earlyTurns());
            }
            assertTrue(played.player(side).score() > 0, "it found a checkpoint: " + played.result());
            if (match % 4 == 0) {
                assertNull(played.verify().difference());
            }
            wins += played.result().winner() == side ? 1 : 0;
            turns += played.result().turns();
        }
        report.publishEntry(name + ": " + matches + " matches without a fault, " + wins + " won, " + turns + " turns");
    }

    private Path source(String name) throws IOException {
        Path file = folder.resolve(name);
        try (InputStream in = ContestantBotsTest.class.getResourceAsStream("/codingame/" + name)) {
            assertNotNull(in, name);
            Files.copy(in, file);
        }
        return file;
    }

    private static int run(String... command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes());
        assertTrue(process.waitFor(60, TimeUnit.SECONDS), said);
        return process.exitValue();
    }

    private static boolean onPath(String program) {
        String path = System.getenv("PATH");
        for (String each : path == null ? new String[0] : path.split(java.io.File.pathSeparator)) {
            if (Files.isExecutable(Path.of(each, program))) {
                return true;
            }
        }
        return false;
    }
}
