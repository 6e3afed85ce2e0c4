package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.CommandLine;
import steward.bot.process.JavaProcess;

/** The program as a process of its own: what its streams and signals do. */
@Tag("process")
@Timeout(300)
public class ProcessTest {

    @TempDir
    private Path folder;

    @BeforeEach
    public void shell() {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
    }

    public static String steward(String... arguments) {
        return CommandLine.quote(JavaProcess.words(Main.class, arguments));
    }

    /** Runs a line of shell; what it writes to either stream, then its status. */
    public static String shell(String line) throws IOException, InterruptedException {
        Process process = new ProcessBuilder("sh", "-c", "( " + line + "\n) 2>&1; echo status $?").start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return said;
    }

    @Test
    void aReaderThatGoesAwayIsNoProblem() throws IOException, InterruptedException {
        Path file = Files.write(folder.resolve("x.jsonl"), Recorded.duel(3).bytes());
        assertEquals("duel (pod-race), seed 3, no deadlines\nstatus 0\n",
            shell(steward("replay", file.toString()) + " | head -n 1"));
        assertEquals("status 0\n", shell(steward("replay", file.toString(), "--frames", "--player", "0") + " | :"));
    }

    @Test
    void anOutputThatCannotBeWrittenIsTold() throws IOException, InterruptedException {
        assumeTrue(Files.isWritable(Path.of("/dev/full")), "there is no /dev/full");
        String said = shell(steward("explain", "duel") + " >/dev/full");
        assertTrue(said.startsWith("steward: cannot write the output: ") && said.endsWith("status 1\n"), said);
    }

    @Test
    @Tag("campaign")
    void namesKeepTheirLettersInEveryLocale() throws IOException, InterruptedException {
        byte[] renamed = new String(Recorded.duel(3).bytes(), StandardCharsets.UTF_8).replace("pilot-0", "pilöt")
            .getBytes(StandardCharsets.UTF_8);
        Path file = Files.write(folder.resolve("x.jsonl"), renamed);
        assertTrue(shell("LC_ALL=C " + steward("replay", file.toString(), "--quiet")).contains("player 0  pilöt"));
    }

    @Test
    void anInterruptedMatchLeavesItsTurnsAndNoBots() throws IOException, InterruptedException {
        Path file = folder.resolve("x.jsonl");
        Path pids = folder.resolve("pids");
        ShellBots bots = new ShellBots(folder);
        String stuck = "stuck=sh -c 'echo $$ >>" + pids + "; read -r setup; read -r turn; "
            + "echo \"{\\\"pods\\\":[{\\\"x\\\":1,\\\"y\\\":1,\\\"thrust\\\":0}]}\"; sleep 60'";
        Process match = new ProcessBuilder("sh", "-c", "exec " + steward("match", "--scene", "duel", "--no-deadline",
            "--sandbox", "off", "--out", file.toString(), "--bot", bots.driver("a", ShellBots.CHECKPOINT),
            "--bot", stuck))
            .redirectErrorStream(true).start();
        try {
            while (!(Files.exists(file) && Files.readString(file).lines().count() >= 2) && match.isAlive()) {
                Thread.sleep(20);
            }
            match.toHandle().destroy();
            String said = new String(match.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertEquals("steward: interrupted; the turns so far are in " + file + "\n", said);
        } finally {
            match.destroyForcibly();
        }
        Cli verified = Cli.run("replay", file.toString(), "--verify");
        assertEquals("verified up to the cut: states of 1 of 1 turn\n", verified.out());
        long pid = Long.parseLong(Files.readString(pids).strip());
        while (isRunning(pid)) {
            Thread.sleep(20);
        }
    }

    /**
     * The table is begun before anything is measured: interrupted then, the command does not claim that there are rows.
     */
    @Test
    @Tag("campaign")
    void aBenchmarkThatIsInterruptedAtOnceSaysThatItHasNothing() throws IOException, InterruptedException {
        Path table = folder.resolve("out/bench.csv");
        Process bench = new ProcessBuilder("sh", "-c", "exec " + steward("bench", "--only", "crowds", "--bodies",
            "1000", "--out", folder.resolve("out").toString())).redirectErrorStream(true).start();
        try {
            int read = 0;
            while (read != ':') {                      // up to the title of the table
                read = bench.getInputStream().read();
                assertTrue(read >= 0, "it ended before the title");
            }
            bench.toHandle().destroy();
            String said = new String(bench.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertTrue(said.endsWith("steward: interrupted; no row was complete\n"), said);
            assertEquals(1, Files.readAllLines(table).size());
        } finally {
            bench.destroyForcibly();
        }
    }

    /** A zombie process stays in the process table, without a command line, until its parent waits for it. */
    public static boolean isRunning(long pid) {
        return ProcessHandle.of(pid).flatMap(handle -> handle.info().commandLine()).isPresent();
    }
}
