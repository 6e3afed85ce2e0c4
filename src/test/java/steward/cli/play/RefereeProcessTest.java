package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Main;
import steward.cli.TextShellBots;

/** {@code steward referee} as a process of its own, which a tool has started: nothing but the answer, on one stream. */
@Tag("process")
class RefereeProcessTest {

    @TempDir
    private Path folder;

    private static Process start(String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:TieredStopAtLevel=1", "-cp",
            System.getProperty("java.class.path"), Main.class.getName(), "referee"));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).start();
    }

    private static String end(Process process) throws IOException, InterruptedException {
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(process.waitFor(30, TimeUnit.SECONDS));
        return "status " + process.exitValue() + err;
    }

    @Test
    void printsTheScoresAndNothingElse() throws IOException, InterruptedException {
        TextShellBots bots = new TextShellBots(folder);
        Process process = start("-scene", "duel", "--no-deadline", "-p1", bots.driver(), "-p2", bots.idler(2), "-d",
            "seed=4", "--sandbox", "off");
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals("1\n-1\n", out);
        String end = end(process);
        assertTrue(end.startsWith("status 0steward: warning: -p2 has failed in turn 2: line 1 of 1: ")
            && end.lines().skip(1).allMatch(line -> line.startsWith("  ")), end);
    }
}
