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
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.io.TempDir;
import steward.match.Seat;
import steward.match.TestScenes;
import steward.match.TimeControl;

/**
 * Three Mean Max bots as contestants write them, in three languages, on the site's lines with seats rotated; those
 * whose language is not there leave their seat to the one in Java. More games: {@code gradle
 * campaigns -Psteward.games=100}.
 */
@Tag("process")
class MeanMaxContestantsTest {

    @TempDir
    private Path folder;

    @Test
    @Tag("campaign")
    void theyPlayWithoutAFault(TestReporter report) throws IOException, InterruptedException {
        play(report, Integer.getInteger("steward.games", 6));
    }

    private void play(TestReporter report, int matches) throws IOException, InterruptedException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this Java has no compiler");
        assertEquals(0, compiler.run(null, null, null, "-d", folder.toString(), source("Ram.java").toString()));
        List<String> java = List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", folder.toString(), "Player");
        boolean python = isThere("python3", "-c", "import math, sys");
        Path program = folder.resolve("tar");
        boolean cpp = isThere("g++", "-O1", "-o", program.toString(), source("tar.cpp").toString());
        List<List<String>> commands = List.of(java,
            python ? List.of("python3", source("harvester.py").toString()) : java,
            cpp ? List.of(program.toString()) : java);
        int[] won = new int[commands.size()];
        int turns = 0;
        for (int match = 0; match < matches; match++) {
            Seat[] seats = new Seat[commands.size()];
            for (int seat = 0; seat < seats.length; seat++) {
                int bot = (seat + match) % seats.length;
                seats[seat] = TextMatches.program("bot " + bot, commands.get(bot));
            }
            TextMatches played = TextMatches.play(TestScenes.open("mean-max"), match, TimeControl.UNLIMITED, seats);
            for (int seat = 0; seat < seats.length; seat++) {
                assertNull(played.player(seat).fault(), "seed " + match + ", seat " + seat);
                assertEquals(0, played.player(seat).earlyTurns());
                won[(seat + match) % seats.length] += played.result().winner() == seat ? 1 : 0;
            }
            if (match % 3 == 0) {
                assertNull(played.verify().difference());
            }
            turns += played.result().turns();
        }
        List<Integer> wins = new ArrayList<>();
        for (int each : won) {
            wins.add(each);
        }
        report.publishEntry(matches + " matches without a fault, " + turns + " turns; won " + wins
            + " (Java, Python " + python + ", C++ " + cpp + ")");
        assertTrue(turns > 0);
    }

    private Path source(String name) throws IOException {
        Path file = folder.resolve(name);
        try (InputStream in = MeanMaxContestantsTest.class.getResourceAsStream("/meanmax/" + name)) {
            assertNotNull(in, name);
            Files.copy(in, file);
        }
        return file;
    }

    private static boolean isThere(String... command) throws InterruptedException {
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
            process.getOutputStream().close();
            process.getInputStream().readAllBytes();
            return process.waitFor(60, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException notInstalled) {
            return false;
        }
    }
}
