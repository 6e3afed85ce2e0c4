package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.bot.command.CommandLine;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;
import steward.cli.shared.ExitStatus;

/** {@code steward match} where golden files do not reach: terminals, seeds that are drawn, pipes, full disks. */
@Tag("process")
@Timeout(60)
class MatchCommandTest extends ShellBotsCase {

    /** The first player passes a checkpoint and stays, the second passes none and is out after 51 turns. */
    private Cli duel(String... more) {
        return duel(false, bots.driver("near", ShellBots.CHECKPOINT), bots.driver("far", ShellBots.NOWHERE), more);
    }

    private static Cli duel(boolean terminal, String first, String second, String... more) {
        return Cli.run(terminal, Cli.words(List.of("match", "--scene", "duel", "--bot", first, "--bot", second,
            "--no-deadline"), more));
    }

    @Test
    void theReplayGoesToTheStandardOutput() throws IOException {
        Cli cli = duel("--seed", "7", "--out", "-");
        assertTrue(cli.err().startsWith("near wins: the other player is out, 51 turns (duel, seed 7)\n"), cli.err());
        Path file = Files.writeString(folder.resolve("piped.jsonl"), cli.out());
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            Cli.run("replay", file.toString(), "--verify").out());
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
    void linesBeyondAnAnswerAreAWarning() {
        String twice = "sh -c 'while read -r line; do case $line in *turnsLeft*) "
            + "a=\"{\\\"pods\\\":[{\\\"x\\\":1,\\\"y\\\":1,\\\"thrust\\\":0}]}\"; "
            + "echo \"$a\n$a\";; esac; done'";              // one write: the second line is there with the first
        Cli cli = duel(false, bots.driver("good", ShellBots.CHECKPOINT), "twice=" + twice).done();
        assertTrue(cli.out().contains("warning: twice wrote "), cli.out());
    }

    @Test
    void aFullDiskEndsTheMatchWithoutAResult() {
        assumeTrue(Files.isWritable(Path.of("/dev/full")), "there is no /dev/full");
        Cli cli = duel("--overwrite", "--out", "/dev/full", "--json");
        assertEquals(ExitStatus.FAILED, cli.status());
        assertEquals("", cli.out());
        assertTrue(cli.err().startsWith("steward: the match could not be brought to a result: "), cli.err());
    }

    /** Failures of other kinds, wherever they are told, are in golden files. */
    @Test
    void aBotThatNeverFlushesIsAskedWhetherItDoes() throws IOException {
        String out = late("sleep 30", "0.2");
        assertTrue(out.contains("me failed in turn 1: no answer within 200 ms"), out);
        assertTrue(out.contains("\n  hint: nothing ever came on its stdout; does it flush after every answer, "
            + "and start in time?\n"), out);
        String late = late("read -r setup; read -r turn; echo '{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}'; sleep 30",
            "0.5");
        assertTrue(late.contains("me failed in turn 2: no answer within ") && !late.contains("hint:"), late);
    }

    private String late(String script, String timeFactor) throws IOException {
        String bot = "me=sh " + CommandLine.quote(List.of(Files.writeString(folder.resolve("me.sh"), script)
            .toString()));
        return Cli.run("match", "--scene", "duel", "--seed", "7", "--bot", bot, "--bot",
            bots.driver("other", ShellBots.CHECKPOINT), "--time-factor", timeFactor).out();
    }
}
