package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.CommandLine;
import steward.cli.Cli;
import steward.cli.ShellBots;

/** Hints to a bot that is late; other failures, wherever they are told, are in golden files. */
@Tag("process")
@Timeout(60)
class FailureReportTest {

    private static final String ANSWER = "echo '{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}'; ";

    @TempDir
    private Path folder;

    @BeforeEach
    void shell() {
    }

    /** A match against a bot that is a shell script. */
    private Cli match(String prefix, String script, String... more) throws IOException {
        String bot = "me=" + prefix + "sh "
            + CommandLine.quote(List.of(Files.writeString(folder.resolve("me.sh"), script).toString()));
        return Cli.run(List.of("match", "--scene", "duel", "--seed", "7", "--bot", bot, "--bot",
            new ShellBots(folder).driver("other", ShellBots.CHECKPOINT)), more);
    }
    @Test
    void aBotThatNeverFlushesIsAskedWhetherItDoes() throws IOException {
        String out = match("", "sleep 30", "--time-factor", "0.2").out();
        assertTrue(out.contains("me failed in turn 1: no answer within 200 ms"), out);
        assertTrue(out.contains("\n  hint: nothing ever came on its stdout; does it flush after every answer, "
            + "and start in time?\n"), out);
        String late = match("", "read -r setup; read -r turn; " + ANSWER + "sleep 30", "--time-factor", "0.5").out();
        assertTrue(late.contains("me failed in turn 2: no answer within ") && !late.contains("hint:"), late);
    }
}
