package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.bot.Answer;
import steward.bot.Player;

/**
 * A process that has left the bot's group, and whose parents are gone, is not found. It may hold the bot's pipes
 * without end: then the asking thread is abandoned, and another one goes on.
 */
@Tag("process")
class AbandonedBotTest {

    private static final long SHORT = 50_000_000;

    /** Starts a process outside the group, with the bot's input and output, not its stderr; it says its number. */
    private static final String LEAVE =
        "exec 3<&0; sh -c 'setsid sh -c \"echo \\$\\$; exec sleep 1000\" <&3 2>/dev/null &'; echo ready; exec 3<&-; ";

    private final BlockingQueue<Answer> given = new LinkedBlockingQueue<>();
    private final BlockingQueue<Player.Ending> endings = new LinkedBlockingQueue<>();
    private volatile Thread goesOn;
    private ProcessHandle leftover;

    @BeforeEach
    void groups() {
        ScriptedBots.assumeGroups();
    }

    @AfterEach
    void endLeftover() {
        if (leftover != null) {
            leftover.destroyForcibly();
        }
    }

    private BotProcess leavingBot(String then) {
        BotProcess bot = ScriptedBots.bot(LEAVE + then);
        String text = ScriptedBots.answer(bot, "a\n", 2).text();
        leftover = ProcessHandle.of(Long.parseLong(text.replaceAll("[^0-9]", ""))).orElseThrow();
        bot.onAbandoned(answer -> {
            goesOn = Thread.currentThread();
            bot.close();
            given.add(answer);
        });
        return bot;
    }

    /** Asks on a thread that will be stuck; gives the fault that another thread received meanwhile. */
    private Answer abandoned(BotProcess bot, String frame) throws InterruptedException {
        byte[] bytes = frame.getBytes(StandardCharsets.US_ASCII);
        Answer untouched = new Answer();
        Thread stuck = new Thread(() -> endings.add(bot.ask(bytes, bytes.length, 1, SHORT, untouched)));
        stuck.setDaemon(true);
        stuck.start();
        Answer answer = given.poll(60, TimeUnit.SECONDS);
        assertNotNull(answer, "nobody was given the fault");
        assertNotSame(untouched, answer);
        assertNotSame(stuck, goesOn);
        assertTrue(goesOn.isDaemon());
        assertTrue(stuck.isAlive());
        assertTrue(endings.isEmpty());

        leftover.destroyForcibly();
        assertEquals(Player.Ending.ABANDONED, endings.poll(60, TimeUnit.SECONDS));
        assertNull(untouched.fault());
        assertNull(untouched.stderr());
        assertEquals(0, untouched.length());
        assertTrue(given.isEmpty(), "called twice");
        return answer;
    }

    @Test
    void aReadThatCannotBeEndedIsAbandoned() throws InterruptedException {
        BotProcess bot = leavingBot("echo late >&2; exec sleep 1000");
        Answer answer = abandoned(bot, "b\n");
        assertTrue(answer.fault().matches("no answer within 50 ms \\(waited [0-9]+ ms\\): " + ScriptedBots.PARTS),
            answer.fault());
        assertTrue(answer.nanos() >= SHORT);
    }

    @Test
    void aWriteThatCannotBeEndedIsAbandoned() throws InterruptedException {
        BotProcess bot = leavingBot("exec sleep 1000");
        Answer answer = abandoned(bot, "x".repeat(1 << 20));
        assertTrue(answer.fault().matches("did not read its input within 50 ms \\(waited [0-9]+ ms\\): "
            + ScriptedBots.PARTS),
            answer.fault());
    }

    /**
     * There is no limit that could end this wait. Should the bot have exited before the read began, its output ends
     * there and then, and no thread has to be abandoned.
     */
    @Test
    void theExitOfTheBotIsNoticedAlthoughItsOutputStaysOpen() throws InterruptedException {
        BotProcess bot = leavingBot("read -r a; read -r b; sleep 0.1; exit 6");
        Answer answer = new Answer();
        Thread asking = new Thread(() -> {
            Player.Ending ending = ScriptedBots.ask(bot, "b\n", 1, ScriptedBots.FOREVER, answer);
            if (ending == Player.Ending.FAULT) {
                given.add(answer);
            }
            endings.add(ending);
        });
        asking.setDaemon(true);
        asking.start();
        Answer fault = given.poll(60, TimeUnit.SECONDS);
        assertNotNull(fault, "the exit was not noticed");
        assertEquals("exited with status 6 before answering", fault.fault());
        leftover.destroyForcibly();
        Player.Ending ending = endings.poll(60, TimeUnit.SECONDS);
        assertEquals(fault == answer ? Player.Ending.FAULT : Player.Ending.ABANDONED, ending);
        bot.close();
    }

    @Test
    void withoutAnybodyToGoOnTheFaultWaitsForTheThread() throws InterruptedException {
        BotProcess bot = leavingBot("exec sleep 1000");
        bot.onAbandoned(null);
        Answer answer = new Answer();
        Thread stuck = new Thread(() -> endings.add(ScriptedBots.ask(bot, "b\n", 1, SHORT, answer)));
        stuck.setDaemon(true);
        stuck.start();
        assertNull(endings.poll(500, TimeUnit.MILLISECONDS));
        leftover.destroyForcibly();
        assertEquals(Player.Ending.FAULT, endings.poll(60, TimeUnit.SECONDS));
        assertTrue(answer.fault().startsWith("no answer within 50 ms"), answer.fault());
        bot.close();
    }

    @Test
    void theEndDoesNotWaitForAnInputThatNobodyReads() throws InterruptedException {
        BotProcess bot = leavingBot("exec sleep 1000");
        Thread ending = new Thread(() -> ScriptedBots.finish(bot, "x".repeat(1 << 20) + "\n"));
        ending.setDaemon(true);
        ending.start();
        ending.join(60_000);
        assertFalse(ending.isAlive());
        assertTrue(leftover.isAlive());
    }
}
