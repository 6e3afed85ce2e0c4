package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Player;

/** A bot is killed with everything that it has started. */
@Tag("process")
class BotGroupTest {

    private static final long SHORT = 50_000_000;

    @BeforeEach
    void groups() {
        ScriptedBots.assumeGroups();
    }

    private static long[] pids(Player bot, int lines) {
        String text = ScriptedBots.answer(bot, "a\n", lines).text();
        return Arrays.stream(text.split("\\s+")).mapToLong(Long::parseLong).toArray();
    }

    /** The bot answers with process numbers; then it is too late in its second turn, and all of them are gone. */
    private static void nothingIsLeftAfterTheDeadline(String script, int lines) {
        try (BotProcess bot = ScriptedBots.bot(script)) {
            long[] pids = pids(bot, lines);
            Arrays.stream(pids).forEach(pid -> assertTrue(ScriptedBots.isRunning(pid), "not running: " + pid));
            String fault = ScriptedBots.fault(bot, "b\n", SHORT).fault();
            assertTrue(fault.startsWith("no answer within 50 ms (waited "), fault);
            Arrays.stream(pids).forEach(ScriptedBots::assertGone);
        }
    }

    /** At the end of a match nothing is left of a bot that would go on. */
    private static void nothingIsLeftAfterTheEnd(String script, int lines) {
        long[] pids;
        try (BotProcess bot = ScriptedBots.bot(script)) {
            pids = pids(bot, lines);
        }
        Arrays.stream(pids).forEach(ScriptedBots::assertGone);
    }

    /** The row says who is left behind, and in how many lines the script prints process numbers. */
    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        a wrapper script and its child | 1 | sh -c 'echo $$; sleep 1000; :'; sleep 1000
        a background child | 1 | sleep 1000 & echo $$ $!; sleep 1000; :
        a grandchild whose parent is gone holds the output | 2 | sh -c 'sleep 1000 & echo $!'; echo $$; sleep 1000; :
        a child that has left the group, a descendant | 1 | setsid sh -c 'echo $$; sleep 1000' & sleep 1000; :
        a bot that ignores signals | 1 | trap '' TERM INT HUP QUIT PIPE; echo $$; while :; do sleep 1000; done
        """)
    void nothingIsLeftOf(String what, int lines, String script) {
        nothingIsLeftAfterTheDeadline(script, lines);
        nothingIsLeftAfterTheEnd(script, lines);
    }

    @Test
    void aBackgroundChildThatOutlivesItsParent() {
        BotProcess bot = ScriptedBots.bot("sleep 1000 >/dev/null & echo $! $$");
        long[] pids = pids(bot, 1);
        ScriptedBots.assertGone(pids[1]);
        assertTrue(ScriptedBots.isRunning(pids[0]));
        bot.close();
        ScriptedBots.assertGone(pids[0]);
    }

    /** Without a limit nothing but the exit of the first process can end this wait. */
    @Test
    void aBackgroundChildThatHoldsTheOutputOfABotThatHasExited() {
        for (int round = 0; round < 5; round++) {
            try (BotProcess bot = ScriptedBots.bot("sleep 1000 & echo $!; read -r a; read -r b; exit 5")) {
                long[] pids = pids(bot, 1);
                assertEquals("exited with status 5 before answering",
                    ScriptedBots.fault(bot, "b\n", ScriptedBots.FOREVER).fault());
                ScriptedBots.assertGone(pids[0]);
            }
        }
    }

    @Test
    void botsInheritNothingFromEachOther() throws InterruptedException {
        String script = "read -r l; ls /proc/$$/fd; echo .; while read -r l; do echo \"$l\"; done";
        BotProcess[] bots = new BotProcess[12];
        String[] descriptors = new String[bots.length];
        Thread[] threads = new Thread[3];
        for (int t = 0; t < threads.length; t++) {
            int first = t;
            threads[t] = new Thread(() -> {
                for (int b = first; b < bots.length; b += threads.length) {
                    bots[b] = ScriptedBots.bot(script);
                    descriptors[b] = ScriptedBots.answer(bots[b], "a\n", 4).text();
                }
            });
            threads[t].start();
        }
        for (Thread thread : threads) {
            thread.join();
        }
        for (int b = 0; b < bots.length; b++) {
            assertEquals("0\n1\n2\n.", descriptors[b]);
            assertEquals("still there", ScriptedBots.reply(bots[b], "still there\n"));
            bots[b].close();
        }
    }
}
