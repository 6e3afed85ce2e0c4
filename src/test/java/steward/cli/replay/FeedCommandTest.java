package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.ProcessTest;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;

/** {@code steward feed} where golden files do not reach: processes, pipes, terminals. */
@Tag("process")
@Timeout(60)
class FeedCommandTest {

    /** Arguments: thrust, the turn in which it is another (0: never), what to do there. */
    private static final String BOT = """
        t=0
        while IFS= read -r line; do
          case $line in *'"type":"turn"'*) ;; *) continue ;; esac
          t=$((t + 1)); thrust=$1
          [ $t != "$2" ] || eval "$3"
          echo "{\\"pods\\":[{\\"x\\":10500,\\"y\\":3500,\\"thrust\\":$thrust}]}"
        done
        """;
    @TempDir
    private Path folder;
    private Path replay;
    private String script;

    /** A match of 51 turns: "near" always says the same, "far" is out at its end. */
    @BeforeEach
    void match() throws IOException {
        script = Files.writeString(folder.resolve("bot.sh"), BOT).toString();
        replay = folder.resolve("x.jsonl");
        ShellBots bots = new ShellBots(folder);
        Cli.run("match", "--scene", "duel", "--no-deadline", "--seed", "7", "--out", replay.toString(),
            "--bot", bots.driver("near", ShellBots.CHECKPOINT), "--bot", bots.driver("far", ShellBots.NOWHERE)).done();
    }

    private Cli feed(String options, String... command) {
        return feed(new ByteArrayInputStream(new byte[0]), options, command);
    }

    private Cli feed(InputStream in, String options, String... command) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        String[] words = ("feed " + replay + (options.contains("--player") ? " " : " --player 0 ") + options).strip()
            .split(" +");
        String[] call = Arrays.copyOf(words, words.length + 1 + command.length);
        call[words.length] = "--";
        System.arraycopy(command, 0, call, words.length + 1, command.length);
        int status = Main.run(new Streams(in, false, out, err, false, false), call);
        return new Cli(status, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    private String[] bot(String... arguments) {
        String[] words = {"sh", script, arguments[0], arguments.length > 1 ? arguments[1] : "0",
            arguments.length > 2 ? arguments[2] : ""};
        return words;
    }

    @Test
    void aBotThatEndsWhileItIsHeldNeedsNoEnter() throws IOException {
        try (PipedOutputStream nobody = new PipedOutputStream(); PipedInputStream in = new PipedInputStream(nobody)) {
            Cli cli = feed(in, "--until 9", bot("100", "9",
                "echo '{\"pods\":[{\"x\":10500,\"y\":3500,\"thrust\":100}]}'; exit 0"));
            assertEquals(ExitStatus.DONE, cli.status(), cli.out());
            assertTrue(cli.out().contains("stopped after turn 9; process "), cli.out());
        }
    }

    /** Many bots read in an endless loop: they would go on answering for ever. */
    @Test
    @Tag("campaign")
    void aBotThatDoesNotSeeTheEndIsEnded() throws IOException, InterruptedException {
        Path pid = folder.resolve("pid");
        Cli cli = feed("--quiet", "sh", "-c", "echo $$ >" + pid + "; read -r setup; while :; do read -r line; "
            + "echo '{\"pods\":[{\"x\":10500,\"y\":3500,\"thrust\":100}]}'; done");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertFalse(ProcessHandle.of(Long.parseLong(Files.readString(pid).strip())).map(ProcessHandle::isAlive)
            .orElse(false));
    }

    /** A loop around a read that fails, as beginners write it, said so thousands of times behind the verdict. */
    @Test
    void theVerdictIsTheLastWordAndABotThatSpinsAtTheEndSaysNoMore() throws IOException, InterruptedException {
        String spins = ProcessTest.steward("feed", replay.toString(), "--player", "0", "--quiet", "--", "sh", "-c",
            "sh " + script + " 100; echo loose >&2; while :; do echo end of file >&2; done");
        assertEquals("51 turns compared: 51 the same, 0 different\nstatus 0\n",
            ProcessTest.shell(spins).replaceFirst("process.*\n", ""));
        String ends = ProcessTest.steward("feed", replay.toString(), "--player", "0", "--quiet", "--", "sh", "-c",
            "sh " + script + " 100; echo bye >&2");
        assertEquals("bye\n51 turns compared: 51 the same, 0 different\nstatus 0\n",
            ProcessTest.shell(ends).replaceFirst("process.*\n", ""));
    }

    @Test
    void stderrOfTheBotIsOurs() throws IOException, InterruptedException {
        String call = ProcessTest.steward("feed", replay.toString(), "--player", "0", "--quiet", "--", "sh", script,
            "100", "5", "echo so far >&2");
        assertTrue(ProcessTest.shell(call + " >/dev/null").equals("so far\nstatus 0\n"));
    }

    @Test
    void aReplayComesAndGoesByPipes() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        try (InputStream in = Files.newInputStream(replay)) {
            int status = Main.run(new Streams(in, false, out, err, false, false), "feed", "-", "--player", "near",
                "--from-turn", "20", "--replace", "--quiet", "--out", "-", "--", "sh", script, "100", "0", "");
            assertEquals(ExitStatus.DONE, status, err.toString(StandardCharsets.UTF_8));
        }
        assertTrue(err.toString(StandardCharsets.UTF_8).contains("32 turns played by the bot\n"));
        ByteArrayOutputStream verified = new ByteArrayOutputStream();
        Main.run(new Streams(new ByteArrayInputStream(out.toByteArray()), false, verified, err, false, false),
            "replay", "-", "--verify");
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            verified.toString(StandardCharsets.UTF_8));
    }

    @Test
    void waitingIsToldOnATerminal() throws InterruptedException {
        ByteArrayOutputStream terminal = new ByteArrayOutputStream();
        PrintStream printed = new PrintStream(terminal, true, StandardCharsets.UTF_8);
        WaitingNotice notice = new WaitingNotice(printed, "json", 50);
        notice.asked(1);
        notice.answered();
        notice.asked(2);
        while (terminal.size() == 0) {
            Thread.sleep(10);
        }
        notice.answered();
        assertEquals("waiting for the bot's answer to turn 2 (it is sent json)\n",
            terminal.toString(StandardCharsets.UTF_8));
        WaitingNotice nowhere = new WaitingNotice(null, "json", 0);
        nowhere.asked(1);
        nowhere.answered();
    }

    @Test
    void wrongCallsAreRefusedBeforeTheBotIsStarted() {
        Path started = folder.resolve("started");
        feed("--until 52", "sh", "-c", "touch " + started).assertRefused("--until: found 52, expected 1 to 51");
        assertFalse(Files.exists(started));
    }
}
