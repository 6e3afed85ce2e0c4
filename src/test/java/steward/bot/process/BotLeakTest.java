package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import steward.match.TestSize;

/** Many matches in one JVM leave nothing behind. */
@Tag("process")
@Isolated("counts descriptors, threads and files of the whole JVM")
class BotLeakTest {

    @BeforeEach
    void groups() {
        ScriptedBots.assumeGroups();
    }

    private static int descriptors() {
        return new File("/proc/self/fd").list().length;
    }

    private static Set<String> temporaryFiles() {
        Set<String> names = new TreeSet<>();
        for (String name : new File(System.getProperty("java.io.tmpdir")).list()) {
            if (name.startsWith("steward-") && name.endsWith(".stderr")) {
                names.add(name);
            }
        }
        return names;
    }

    /** Returns the number of our threads that are there for one bot. */
    private static long threads() {
        return Thread.getAllStackTraces().keySet().stream().map(Thread::getName)
            .filter(name -> name.equals("steward-deadline") || name.equals("steward-spare")).count();
    }

    private static void play(int number) {
        BotProcess bot = ScriptedBots.bot(number % 2 == 0
            ? "while read -r l; do echo \"$l\"; done"
            : "read -r l; echo \"$l\"; echo oh >&2; sleep 1000 >/dev/null & exit 3");
        ScriptedBots.tell(bot, "setup\n");
        assertEquals("setup", ScriptedBots.reply(bot, "turn\n"));
        if (number % 4 == 1) {
            ScriptedBots.fault(bot, "turn\n", ScriptedBots.FOREVER);
        }
        ScriptedBots.finish(bot, "end\n");
    }

    @Test
    @Tag("sized")
    void manyBotsInSequenceLeaveNothing() {
        for (int number = 0; number < 8; number++) {
            play(number);
        }
        long sentinel = Sentinel.shared().pid();
        long threadsBefore = threads();
        Set<String> filesBefore = temporaryFiles();
        int descriptorsBefore = descriptors();
        for (int number = 0; number < TestSize.of(90, 300); number++) {
            play(number);
        }
        // The JDK closes its ends when it has taken note of an exit; class loading may have opened a few files.
        ScriptedBots.await("descriptors are left open", () -> descriptors() <= descriptorsBefore + 5);
        // If no spare thread is idle again when the next bot needs one, another is started: far from one per bot.
        ScriptedBots.await("threads are left behind", () -> threads() <= threadsBefore + 10);
        Set<String> files = temporaryFiles();
        files.removeAll(filesBefore);
        assertEquals(Set.of(), files);
        assertEquals(sentinel, Sentinel.shared().pid());
        assertEquals(0, Sentinel.shared().size());
    }
}
