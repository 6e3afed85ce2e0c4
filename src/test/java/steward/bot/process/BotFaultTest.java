package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Answer;
import steward.bot.Player;

/** Ways in which a bot fails at no level of isolation in particular; {@link SandboxVerdictsTest} has the others. */
@Tag("process")
class BotFaultTest {

    private static final long SHORT = 50_000_000;

    @BeforeEach
    void groups() {
        ScriptedBots.assumeGroups();
    }

    /** Beginnings of an answer that are none: what came, of how many lines, and what the fault says of it. */
    @ParameterizedTest
    @CsvSource({"'{\"x\":1', 1, '6 bytes came, without a line end; '", "'half\nqu', 2, 1 of 2 lines came; "})
    void aPartOfAnAnswerIsNone(String came, int lines, String said) {
        try (BotProcess bot = ScriptedBots.bot("read -r l; printf '1\\n%s' '" + came + "'; exec sleep 1000")) {
            assertEquals("1", ScriptedBots.reply(bot, "a\n"));
            Answer answer = new Answer();
            assertEquals(Player.Ending.FAULT, ScriptedBots.ask(bot, "b\n", lines, SHORT, answer));
            assertTrue(answer.fault().matches("no answer within 50 ms \\(waited [0-9]+ ms\\): " + said.strip() + " "
                + ScriptedBots.PARTS), answer.fault());
            assertEquals(came, answer.text());
            assertTrue(answer.nanos() >= SHORT);
        }
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
    void afterItsFaultItCannotBeAsked() {
        try (BotProcess bot = ScriptedBots.bot("exit 3")) {
            assertEquals("exited with status 3 before answering",
                ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).fault());
            assertEquals("asked again after its end", ScriptedBots.fault(bot, "b\n", ScriptedBots.FOREVER).fault());
        }
    }

    @Test
    void aFaultOfOneBotLeavesOthersAlone() {
        try (BotProcess good = ScriptedBots.bot("exec cat");
             BotProcess bad = ScriptedBots.bot("read -r l; echo 1; exec sleep 1000")) {
            assertEquals("one", ScriptedBots.reply(good, "one\n"));
            ScriptedBots.reply(bad, "a\n");
            ScriptedBots.fault(bad, "b\n", SHORT);
            assertEquals("two", ScriptedBots.reply(good, "two\n"));
        }
    }
}
