package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import tools.jackson.databind.JsonNode;

/** {@code steward match} with real bot processes. Without deadlines: the tests are not about time. */
@Tag("process")
@Timeout(60)
class MatchCommandTest {

    @TempDir
    private Path folder;
    private ShellBots bots;

    @BeforeEach
    void shell() {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        bots = new ShellBots(folder);
    }

    /** The first player passes a checkpoint and stays, the second passes none and is out after 51 turns. */
    private Cli duel(String... more) {
        return duel(false, bots.driver("near", ShellBots.CHECKPOINT), bots.driver("far", ShellBots.NOWHERE), more);
    }

    private static Cli duel(boolean terminal, String first, String second, String... more) {
        String[] call = {"match", "--scene", "duel", "--bot", first, "--bot", second, "--no-deadline"};
        String[] arguments = new String[call.length + more.length];
        System.arraycopy(call, 0, arguments, 0, call.length);
        System.arraycopy(more, 0, arguments, call.length, more.length);
        return Cli.run(terminal, arguments);
    }

    @Test
    void theResultIsToldAndTheReplayVerifies() {
        Path file = folder.resolve("x.jsonl");
        Cli cli = duel("--seed", "7", "--out", file.toString());
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertTrue(cli.out().startsWith("near wins: the other player is out, 51 turns (duel, seed 7)\n"), cli.out());
        assertTrue(cli.out().contains("far is out: no checkpoint in 51 turns\n"), cli.out());
        assertTrue(cli.out().contains("steward replay " + file), cli.out());
        assertEquals("", cli.err());
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            Cli.run("replay", file.toString(), "--verify").out());
    }

    @Test
    void theReplayGoesToTheStandardOutput() throws IOException {
        Cli cli = duel("--seed", "7", "--out", "-");
        assertTrue(cli.err().startsWith("near wins: the other player is out, 51 turns (duel, seed 7)\n"), cli.err());
        Path file = Files.writeString(folder.resolve("piped.jsonl"), cli.out());
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            Cli.run("replay", file.toString(), "--verify").out());
        duel("--out", "-", "--json").assertRefused("--json is printed to the standard output, expected a file");
        duel("--out", "-", "--games", "2").assertRefused("--out: found -, expected a folder");
        duel("--view", "-").assertRefused("--view: found -, expected a file");
    }

    @Test
    void onATerminalLeadChangesAreToldWhileItRuns() {
        Cli cli = duel(true, bots.driver("near", ShellBots.CHECKPOINT), bots.driver("far", ShellBots.NOWHERE));
        assertTrue(cli.out().startsWith("duel, seed "), cli.out());
        assertTrue(cli.out().contains("near leads"), cli.out());
        assertTrue(cli.out().indexOf("near leads") < cli.out().indexOf("near wins"), cli.out());
    }

    @Test
    void aSeedIsDrawnAndPrinted() {
        Cli cli = duel("--quiet");
        assertTrue(cli.out().matches("near wins: the other player is out, 51 turns \\(duel, seed \\d+\\)\n"),
            cli.out());
    }

    @Test
    void jsonIsOneObjectAndNothingElse() {
        Path file = folder.resolve("x.jsonl");
        Cli cli = duel("--seed", "-9223372036854775808", "--json", "--out", file.toString());
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        JsonNode json = cli.json();
        assertEquals("-9223372036854775808", json.get("seed").stringValue());
        assertEquals("duel", json.get("scene").stringValue());
        assertEquals(51, json.get("turns").intValue());
        assertEquals("all others are out", json.get("ending").stringValue());
        assertEquals(0, json.get("winner").intValue());
        assertEquals(file.toString(), json.get("replay").stringValue());
        JsonNode near = json.get("players").get(0);
        assertEquals("near", near.get("name").stringValue());
        assertEquals(bots.driver("near", ShellBots.CHECKPOINT), near.get("bot").stringValue());
        assertEquals(0, near.get("rank").intValue());
        assertEquals(1, near.get("score").doubleValue());
        assertTrue(near.get("out").isNull() && near.get("fault").isNull());
        assertTrue(near.get("answerMs").get("average").doubleValue() > 0);
        assertTrue(near.get("answerMs").get("worst").doubleValue() > 0);
        assertTrue(near.get("answerMs").get("first").doubleValue() > 0);
        assertEquals(0, near.get("warnings").size());
        JsonNode far = json.get("players").get(1);
        assertEquals("no checkpoint in 51 turns", far.get("out").stringValue());
        assertTrue(far.get("fault").isNull());
        assertEquals(1, far.get("rank").intValue());
    }

    @Test
    void aBotThatFailsIsAResultUnlessStrict() {
        String good = bots.driver("good", ShellBots.CHECKPOINT);
        Cli cli = duel(false, good, "bad=sh -c 'exit 3'", "--json");
        assertEquals(ExitStatus.DONE, cli.status());
        JsonNode bad = cli.json().get("players").get(1);
        assertEquals("exited with status 3 before answering", bad.get("fault").stringValue());
        assertEquals(0, cli.json().get("winner").intValue());
        assertTrue(cli.json().get("replay").isNull());
        Cli strict = duel(false, good, "bad=sh -c 'exit 3'", "--strict");
        assertEquals(ExitStatus.FAILED, strict.status());
        assertTrue(strict.out().contains("bad failed in turn 1: exited with status 3 before answering\n"),
            strict.out());
    }

    @Test
    void twoFailuresInOneTurnAreADraw() {
        Cli cli = duel(false, "sh -c 'exit 1'", "sh -c 'exit 1'", "--json");
        assertTrue(cli.json().get("winner").isNull());
        assertEquals("sh-0", cli.json().get("players").get(0).get("name").stringValue());
        assertEquals("sh-1", cli.json().get("players").get(1).get("name").stringValue());
    }

    @Test
    void linesBeyondAnAnswerAreAWarning() {
        String twice = "sh -c 'while read -r line; do case $line in *turnsLeft*) "
            + "a=\"{\\\"pods\\\":[{\\\"x\\\":1,\\\"y\\\":1,\\\"thrust\\\":0}]}\"; "
            + "echo \"$a\n$a\";; esac; done'";              // one write: the second line is there with the first
        Cli cli = duel(false, bots.driver("good", ShellBots.CHECKPOINT), "twice=" + twice);
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertTrue(cli.out().contains("warning: twice wrote "), cli.out());
    }

    @Test
    void aReplayIsOverwrittenWhenAsked() throws IOException {
        Path file = Files.writeString(folder.resolve("x.jsonl"), "old ".repeat(100_000));
        assertEquals(ExitStatus.DONE, duel("--overwrite", "--out", file.toString()).status());
        assertFalse(Files.readString(file).contains("old "));
        assertEquals(ExitStatus.DONE, Cli.run("replay", file.toString(), "--verify").status());
    }

    @Test
    void aFullDiskEndsTheMatchWithoutAResult() {
        assumeTrue(Files.isWritable(Path.of("/dev/full")), "there is no /dev/full");
        Cli cli = duel("--overwrite", "--out", "/dev/full", "--json");
        assertEquals(ExitStatus.FAILED, cli.status());
        assertEquals("", cli.out());
        assertTrue(cli.err().startsWith("steward: the match could not be brought to a result: "), cli.err());
    }
}
