package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.command.CommandLine;
import steward.bot.process.ScriptedBots;
import steward.cli.Cli;
import steward.cli.ProcessTest;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A series in a process of its own: Ctrl-C, and files that cannot grow. */
@Tag("process")
@Timeout(120)
class SeriesProcessTest extends ShellBotsCase {

    private static final int SIGINT_STATUS = 130;
    private static final long PATIENCE_NANOS = 60_000_000_000L;

    private Path replays;

    @BeforeEach
    void shell() {
        replays = folder.resolve("replays");
    }

    /**
     * A bot that plays to the end in its first two games, and in later ones answers twice and then sleeps; every game
     * leaves its process number.
     */
    private String sleeper() throws IOException {
        String script = """
            echo $$ >>%1$s
            games=$(wc -l <%1$s) turns=0
            while IFS= read -r line; do
              case $line in *'"type":"turn"'*) ;; *) continue ;; esac
              turns=$((turns + 1))
              if [ "$games" -gt 2 ] && [ $turns = 3 ]; then : >%2$s; exec sleep 1000; fi
              echo '{"pods":[{"x":5000,"y":99000,"thrust":100}]}'
            done
            """.formatted(folder.resolve("pids"), folder.resolve("asleep"));
        return "sleeper=sh " + CommandLine.quote(List.of(Files.writeString(folder.resolve("sleeper.sh"), script)
            .toString()));
    }

    private String call(String... more) throws IOException {
        return ProcessTest.steward(Cli.words(List.of("match", "--scene", "duel", "--no-deadline",
            "--sandbox", "off", "--seed", "5",
            "--bot", bots.driver("near", ShellBots.CHECKPOINT), "--bot", sleeper(), "--games", "9", "--out",
            replays.toString()), more));
    }

    /** Interrupts it as Ctrl-C does when the third game is under way; what it wrote to stdout. */
    private String interrupted(String... more) throws IOException, InterruptedException {
        ScriptedBots.assumeInterruptible();
        Process match = new ProcessBuilder("sh", "-c", "exec " + call(more))
            .redirectError(folder.resolve("err").toFile()).start();
        try {
            long end = System.nanoTime() + PATIENCE_NANOS;
            while (Files.notExists(folder.resolve("asleep")) && System.nanoTime() < end) {
                Thread.sleep(20);
            }
            Thread.sleep(100);                         // the turns before are being written meanwhile
            new ProcessBuilder("kill", "-INT", Long.toString(match.pid())).start().waitFor();
            String out = new String(match.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertTrue(match.waitFor(30, TimeUnit.SECONDS));
            assertEquals(SIGINT_STATUS, match.exitValue());
            return out;
        } finally {
            match.destroyForcibly();
        }
    }

    private String err() throws IOException {
        return Files.readString(folder.resolve("err"));
    }

    private boolean isThere(int game) {
        return Files.exists(replays.resolve("game-000" + game + ".jsonl"));
    }

    @Test
    void ctrlCPrintsTheTableAndNamesTheReplayThatWasCutOff() throws IOException, InterruptedException {
        String out = interrupted();
        assertTrue(out.startsWith("2 of 9 games of duel, seeds 5 to 13; "), out);
        assertTrue(out.contains("\nnear          1       0       0       0   1.000   "), out);
        Path cut = replays.resolve("game-0003.jsonl");
        assertEquals("steward: interrupted; 2 of 9 games were complete and count; replays that were cut off: " + cut
            + "\n", err());
        assertEquals("verified up to the cut: states of 2 of 2 turns\n",
            Cli.run("replay", cut.toString(), "--verify").out());
        assertFalse(isThere(4));
        assertNoBotIsLeft();
    }

    @Test
    @Tag("campaign")
    void ctrlCPrintsTheJsonAndKeepsNoReplayThatWasNotAskedFor() throws IOException, InterruptedException {
        JsonNode json = JsonMapper.shared().readTree(interrupted("--json", "--keep", "failed"));
        assertTrue(json.get("interrupted").booleanValue());
        assertEquals(9, json.get("planned").intValue());
        assertEquals(2, json.get("games").intValue());
        assertEquals(2, json.get("list").size());
        assertEquals("steward: interrupted; 2 of 9 games were complete and count\n", err());
        assertFalse(isThere(1) || isThere(2) || isThere(3));
        assertNoBotIsLeft();
    }

    private void assertNoBotIsLeft() throws IOException {
        Files.readAllLines(folder.resolve("pids")).forEach(pid -> ScriptedBots.assertGone(Long.parseLong(pid)));
    }

    /** Where no file may grow beyond so many blocks of 512 bytes. */
    @ParameterizedTest
    @ValueSource(ints = {24, 0})
    void aReplayThatCannotGrowKeepsItsTurns(int blocks) throws IOException, InterruptedException {
        String said = ProcessTest.shell("ulimit -f " + blocks + "; exec " + call("--quiet"));
        Path first = replays.resolve("game-0001.jsonl");
        assertTrue(said.contains("steward: game 1 could not be brought to a result: " + first + ": cannot be written: "
            + "File too large; " + (blocks == 0 ? "it had no turn, and is removed\n"
            : "the turns before are in it\n")), said);
        assertTrue(said.contains("steward: the series ends after 1 of 9 games, because "), said);
        assertTrue(said.contains("1 of 9 games of duel: near -, sleeper -; 1 without a result\n"), said);
        assertTrue(said.endsWith("status 1\n"), said);
        assertEquals(blocks > 0, Files.exists(first));
        assertFalse(isThere(2));
    }

    @Test
    @Tag("campaign")
    void oneMatchLeavesNoEmptyReplayEither() throws IOException, InterruptedException {
        Path file = folder.resolve("one.jsonl");
        String said = ProcessTest.shell("ulimit -f 0; exec " + ProcessTest.steward("match", "--scene", "duel", "--bot",
            bots.driver("near", ShellBots.CHECKPOINT), "--bot", bots.driver("far", ShellBots.NOWHERE), "--no-deadline",
            "--sandbox", "off", "--out", file.toString()));
        assertEquals("steward: the match could not be brought to a result: " + file + ": cannot be written: File too "
            + "large; it had no turn, and is removed\nstatus 1\n", said);
        assertFalse(Files.exists(file));
    }
}
