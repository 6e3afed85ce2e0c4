package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.Internal;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.bot.accounting.TreeSampler;

/** Real bots and the clock: what holds on a machine of any speed. */
@Tag("process")
class BotTimeTest {

    private static final long MS = 1_000_000;

    @BeforeEach
    void groups() {
        ScriptedBots.assumeGroups();
        assumeTrue(TreeSampler.showsCpuTime(), "there is no /proc/self/stat");
    }

    /** A referee of its own, which asks its bot twice and prints what became of the second question. */
    static final class StoppedReferee {

        private StoppedReferee() {
        }

        public static void main(String[] arguments) {
            try (BotProcess bot = new BotProcess("bot", List.of("sh", "-c", arguments[0]))) {
                Answer answer = new Answer();
                byte[] frame = {'a', '\n'};
                bot.ask(frame, frame.length, 1, Long.MAX_VALUE, answer);
                Player.Ending ending = bot.ask(frame, frame.length, 1, Long.parseLong(arguments[1]) * MS, answer);
                System.out.println(ending + " " + answer.text() + " " + answer.fault());
            }
        }
    }

    /**
     * The bot answers at once, having stopped the referee, which goes on 1.5 s later: it was thrown out for having
     * taken 1.5 s of 1.
     */
    @Test
    @Tag("slow")
    @Tag("campaign")
    void aStoppedRefereeThrowsNoBotOut() throws Exception {
        String bot = "read -r l; echo ready; read -r l; kill -STOP $PPID; echo answer; sleep 1.5; kill -CONT $PPID; "
            + "read -r l";
        assertEquals("ANSWERED answer null", secondQuestion(bot, 1000));
    }

    private static Path home(Class<?> type) throws URISyntaxException {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    }

    private static String secondQuestion(String bot, long limitMs) throws Exception {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        Process referee = new ProcessBuilder(java, "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp",
            home(Internal.class) + ":" + home(BotProcess.class) + ":"
                + home(StoppedReferee.class), StoppedReferee.class.getName(), bot,
            Long.toString(limitMs)).redirectError(ProcessBuilder.Redirect.INHERIT).start();
        String said = new String(referee.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, referee.waitFor());
        return said.strip();
    }

    @Test
    void aSleepingBotHasDoneNothing() {
        try (BotProcess bot = ScriptedBots.bot("read -r l; echo a; read -r l; exec sleep 1000")) {
            ScriptedBots.reply(bot, "a\n");
            Answer answer = ScriptedBots.fault(bot, "b\n", 200 * MS);
            TimeSpent spent = answer.timeSpent();
            assertNotNull(spent, answer.fault());
            assertEquals(200 * MS, spent.limit());
            assertTrue(answer.fault().endsWith(spent.text()), answer.fault());
            assertEquals(answer.nanos(), spent.taken());
            assertEquals(spent.taken(), spent.unobserved() + spent.computed() + spent.waited() + spent.other());
            assertTrue(spent.cpu() < 100 * MS, spent.text());
        }
    }

    /** Its limit is one of CPU time: it loses by that, unless the machine is ten times too busy. */
    @Test
    void aBotThatComputesTooLongLosesByItsCpuTime() {
        try (BotProcess bot = ScriptedBots.bot("read -r l; echo a; read -r l; while :; do :; done")) {
            bot.limitBy(TimeBasis.CPU);
            ScriptedBots.reply(bot, "a\n");
            Answer answer = ScriptedBots.fault(bot, "b\n", 100 * MS);
            TimeSpent spent = answer.timeSpent();
            assertFalse(spent.computed() == 0, spent.text());
            String over = "no answer within 100 ms of CPU time (used ";
            assertTrue(spent.overCpu() ? spent.cpu() > 100 * MS && answer.fault().startsWith(over)
                : answer.nanos() >= 1000 * MS, answer.fault());
        }
    }

    /** It sleeps longer than its limit, which is nothing to a limit of CPU time. */
    @Test
    void aBotThatSleepsMayAnswerLaterThanItsLimitOfCpuTime() {
        try (BotProcess bot = ScriptedBots.bot("read -r l; echo a; read -r l; sleep 0.7; echo b; read -r l")) {
            bot.limitBy(TimeBasis.CPU);
            ScriptedBots.reply(bot, "a\n");
            Answer answer = new Answer();
            long asked = System.nanoTime();
            assertEquals(Player.Ending.ANSWERED, ScriptedBots.ask(bot, "b\n", 1, 500 * MS, answer), answer.fault());
            assertEquals("b", answer.text());
            assertTrue(System.nanoTime() - asked >= 700 * MS);
        }
    }
}
