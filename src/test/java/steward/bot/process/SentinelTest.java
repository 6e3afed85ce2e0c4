package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The sentinel kills its targets, and survives every signal that can be ignored. */
@Tag("process")
class SentinelTest {

    /** No process has such a number: Linux counts to 4,194,304. */
    private static final String NO_GROUP = "-99999999";

    private final Sentinel sentinel = new Sentinel();
    private Process victim;

    @BeforeEach
    void start() throws IOException {
        ScriptedBots.assumeGroups();
        sentinel.start();
        // Its first report says that it has begun: before that, a signal ends it.
        assertFalse(sentinel.kill(NO_GROUP));
        victim = new ProcessBuilder("setsid", "sh", "-c", "echo; exec sleep 1000").start();
        // Its line says that it has its group.
        assertEquals('\n', victim.getInputStream().read());
    }

    @AfterEach
    void end() {
        if (victim != null) {
            victim.destroyForcibly();
        }
        sentinel.dismiss();
    }

    private String group() {
        return "-" + victim.pid();
    }

    private void assertVictimIsGone() throws InterruptedException {
        assertTrue(victim.waitFor(60, TimeUnit.SECONDS));
        assertEquals(128 + 9, victim.exitValue());
    }

    private void signal(String name) throws IOException, InterruptedException {
        List<String> kill = List.of("sh", "-c", "kill -s \"$1\" \"$2\"", "sh", name, String.valueOf(sentinel.pid()));
        assertEquals(0, new ProcessBuilder(kill).start().waitFor());
    }

    @Test
    void killsGroupsAndSaysWhetherThereWereAny() throws InterruptedException {
        sentinel.watch(group());
        assertTrue(sentinel.kill(group()));
        assertVictimIsGone();
        assertFalse(sentinel.kill(NO_GROUP));
        assertFalse(sentinel.kill(group()));
    }

    @Test
    void isDeafToTheSignalsThatCanBeIgnored() throws IOException, InterruptedException {
        long pid = sentinel.pid();
        for (String name : List.of("TERM", "INT", "HUP", "QUIT", "PIPE", "USR1", "TSTP")) {
            signal(name);
        }
        assertFalse(sentinel.kill(NO_GROUP));
        assertEquals(pid, sentinel.pid());
    }

    @Test
    void killsAllItKnowsAtTheEndOfItsOrdersAndNothingElse() throws IOException, InterruptedException {
        Process forgotten = new ProcessBuilder("setsid", "sh", "-c", "echo; exec sleep 1000").start();
        assertEquals('\n', forgotten.getInputStream().read());
        sentinel.watch("-" + forgotten.pid());
        sentinel.watch(NO_GROUP);
        sentinel.watch(group());
        sentinel.forget("-" + forgotten.pid());
        long pid = sentinel.pid();
        sentinel.endOrders();
        assertVictimIsGone();
        ScriptedBots.assertGone(pid);
        assertTrue(forgotten.isAlive());
        forgotten.destroyForcibly();
    }

    @Test
    void aDeadSentinelIsReplacedByOneThatKnowsTheSame() throws IOException, InterruptedException {
        sentinel.watch(group());
        long first = sentinel.pid();
        signal("KILL");
        ScriptedBots.assertGone(first);
        ScriptedBots.await("it has not noticed", () -> {
            sentinel.watch(NO_GROUP);
            return sentinel.pid() != first;
        });
        sentinel.endOrders();
        assertVictimIsGone();
    }

    @Test
    void aSentinelThatDoesNotAnswerIsReplacedAndTheGroupKilledAllTheSame() throws IOException, InterruptedException {
        sentinel.watch(group());
        long first = sentinel.pid();
        signal("STOP");
        assertTrue(sentinel.kill(group()));
        assertVictimIsGone();
        ScriptedBots.assertGone(first);
        assertNotEquals(first, sentinel.pid());
        assertFalse(sentinel.kill(NO_GROUP));
    }

    @Test
    void aThousandBotsLeaveNoTrace() throws InterruptedException {
        long pid = sentinel.pid();
        sentinel.watch(group());
        for (int bot = 0; bot < 1000; bot++) {
            sentinel.watch(NO_GROUP + bot);
            sentinel.watch(NO_GROUP + bot + 1);
            assertFalse(sentinel.kill(NO_GROUP + bot));
            sentinel.forget(NO_GROUP + bot + 1);
        }
        assertEquals(pid, sentinel.pid());
        assertEquals(1, sentinel.size());
        assertTrue(sentinel.kill(group()));
        assertVictimIsGone();
    }
}
