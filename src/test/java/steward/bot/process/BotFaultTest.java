package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.Answer;
import steward.bot.Player;

/** The ways in which a bot fails, each with its message; no process is left afterwards. */
@Tag("process")
class BotFaultTest {

    private static final long SHORT = 50_000_000;

    @BeforeEach
    void groups() {
        ScriptedBots.assumeGroups();
    }

    /** A bot that answers its first turn with its process number and then does as the script says. */
    private static String then(String script) {
        return "read -r l; echo $$; read -r l; " + script;
    }

    private static Answer secondTurn(String script, long limitNanos) {
        try (BotProcess bot = ScriptedBots.bot(then(script))) {
            long pid = Long.parseLong(ScriptedBots.reply(bot, "a\n"));
            Answer answer = ScriptedBots.fault(bot, "b\n", limitNanos);
            ScriptedBots.assertGone(pid);
            return answer;
        }
    }

    @Test
    void noAnswerInTime() {
        Answer answer = secondTurn("exec sleep 1000", SHORT);
        assertTrue(answer.fault().matches("no answer within 50 ms \\(waited [0-9]+ ms\\): " + ScriptedBots.PARTS),
            answer.fault());
        assertTrue(answer.nanos() >= SHORT);
        assertEquals(0, answer.length());
    }

    @Test
    void theFirstAnswerHasALimitToo() {
        try (BotProcess bot = ScriptedBots.bot("sleep 2; echo 1; exec sleep 1000")) {
            Answer answer = ScriptedBots.fault(bot, "a\n", 1000);
            assertTrue(answer.fault().matches("(no answer|did not read its input) within 0.001 ms \\(waited .*ms\\).*"),
                answer.fault());
        }
    }

    @Test
    void aLineWithoutItsEndIsNoAnswer() {
        try (BotProcess bot = ScriptedBots.bot("read -r l; printf '1\\n{\"x\":1'; exec sleep 1000")) {
            assertEquals("1", ScriptedBots.reply(bot, "a\n"));
            Answer answer = ScriptedBots.fault(bot, "b\n", SHORT);
            assertTrue(answer.fault().matches(
                "no answer within 50 ms \\(waited [0-9]+ ms\\): 6 bytes came, without a line end; "
                + ScriptedBots.PARTS),
                answer.fault());
            assertEquals("{\"x\":1", answer.text());
        }
    }

    @Test
    void someOfTheLinesAreNoAnswer() {
        try (BotProcess bot = ScriptedBots.bot("read -r l; printf '1\\nhalf\\nqu'; exec sleep 1000")) {
            assertEquals("1", ScriptedBots.reply(bot, "a\n"));
            Answer answer = new Answer();
            assertEquals(Player.Ending.FAULT, ScriptedBots.ask(bot, "b\n", 2, SHORT, answer));
            assertTrue(answer.fault().matches("no answer within 50 ms \\(waited [0-9]+ ms\\): 1 of 2 lines came; "
                + ScriptedBots.PARTS),
                answer.fault());
            assertEquals("half\nqu", answer.text());
        }
    }

    @Test
    void exitAtOnce() {
        try (BotProcess bot = ScriptedBots.bot("exit 3")) {
            assertEquals("exited with status 3 before answering",
                ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).fault());
        }
    }

    @Test
    void exitInALaterTurn() {
        Answer answer = secondTurn("printf part; exit 0", ScriptedBots.FOREVER);
        assertEquals("exited with status 0 before answering", answer.fault());
        assertEquals("part", answer.text());
    }

    @Test
    void killedBySignal() {
        assertEquals("killed by signal 11 (SIGSEGV) before answering",
            secondTurn("kill -s SEGV $$", ScriptedBots.FOREVER).fault());
    }

    @Test
    void closedOutput() {
        assertEquals("closed its output before answering",
            secondTurn("exec >&-; exec sleep 1000", ScriptedBots.FOREVER).fault());
    }

    @Test
    void aLineThatIsTooLong() {
        Answer answer = secondTurn("head -c 65537 /dev/zero | tr '\\0' x; exec sleep 1000", ScriptedBots.FOREVER);
        assertEquals("line longer than 65536 bytes", answer.fault());
        assertEquals("x".repeat(1024), answer.text());
    }

    @Test
    void aMegabyteWithoutALineEnd() {
        assertEquals("line longer than 65536 bytes",
            secondTurn("head -c 1000000 /dev/zero; exec sleep 1000", ScriptedBots.FOREVER).fault());
    }

    @Test
    void inputThatIsNeverReadWhileMoreIsSentThanThePipeHolds() {
        try (BotProcess bot = ScriptedBots.bot("read -r l; echo $$; exec sleep 1000")) {
            long pid = Long.parseLong(ScriptedBots.reply(bot, "a\n"));
            Answer answer = ScriptedBots.fault(bot, "x".repeat(1 << 20) + "\n", SHORT);
            assertTrue(answer.fault().matches("did not read its input within 50 ms \\(waited [0-9]+ ms\\): "
                + ScriptedBots.PARTS),
                answer.fault());
            ScriptedBots.assertGone(pid);
        }
    }

    @Test
    void aCommandThatIsNotThere(@TempDir Path folder) {
        try (BotProcess bot = new BotProcess("bot", List.of(folder + "/no/bot"))) {
            Answer answer = ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER);
            assertEquals("exited with status 127 before answering (127: a command was not found)", answer.fault());
            assertTrue(answer.stderr().contains(folder + "/no/bot"), answer.stderr());
        }
    }

    @Test
    void aCommandThatCannotBeExecuted(@TempDir Path folder) throws IOException {
        Path plain = Files.writeString(folder.resolve("bot"), "text");
        assumeTrue(!Files.isExecutable(plain), "every file here is executable");
        try (BotProcess bot = new BotProcess("bot", List.of(plain.toString()))) {
            assertEquals("exited with status 126 before answering (126: a command cannot be executed)",
                ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).fault());
        }
    }

    @Test
    void afterItsFaultItCannotBeAsked() {
        try (BotProcess bot = ScriptedBots.bot("exit 3")) {
            ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER);
            assertEquals("asked again after its end", ScriptedBots.fault(bot, "b\n", ScriptedBots.FOREVER).fault());
        }
    }

    @Test
    void aFaultOfOneBotLeavesOthersAlone() {
        try (BotProcess good = ScriptedBots.bot("exec cat");
             BotProcess bad = ScriptedBots.bot(then("exec sleep 1000"))) {
            assertEquals("one", ScriptedBots.reply(good, "one\n"));
            ScriptedBots.reply(bad, "a\n");
            ScriptedBots.fault(bad, "b\n", SHORT);
            assertEquals("two", ScriptedBots.reply(good, "two\n"));
        }
    }
}
