package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.Internal;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;

/** However a referee ends, its bots end with it, and so does its sentinel. */
@Tag("process")
class RefereeKilledTest {

    /** Answers with the numbers of a child, of a grandchild whose parent has gone, and its own; ignores signals. */
    private static final String FAMILY = "trap '' HUP INT TERM PIPE; sleep 1000 & child=$!;"
        + " grandchild=$(sh -c 'sleep 1000 >/dev/null & echo $!');"
        + " echo $$ $child $grandchild; exec 0<&-; sleep 1000; :";

    @BeforeEach
    void groups() {
        ScriptedBots.assumeGroups();
    }

    /** Where a class was loaded from: the class path of this JVM need not be in its properties. */
    private static Path home(Class<?> type) throws URISyntaxException {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    }

    private static Process referee(String manner, SandboxLevel level) throws Exception {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classPath = home(Internal.class) + ":" + home(BotProcess.class) + ":" + home(KilledReferee.class);
        return new ProcessBuilder(java, "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-Xshare:auto",
            "-cp", classPath, KilledReferee.class.getName(), FAMILY, manner, level.name())
            .redirectError(ProcessBuilder.Redirect.INHERIT).start();
    }

    private static long[] family(Process referee) throws IOException {
        BufferedReader reader = referee.inputReader(StandardCharsets.US_ASCII);
        String line = reader.readLine();
        assertNotNull(line, "the referee did not start its bot");
        return Arrays.stream(line.split(" ")).mapToLong(Long::parseLong).toArray();
    }

    /** Referees of each of these levels that works here end at once; others are reported. */
    private static void endWithTheirBots(TestReporter report, List<SandboxLevel> levels, String manner, String signal)
            throws Exception {
        List<Process> referees = new ArrayList<>();
        try {
            for (SandboxLevel level : levels) {
                if (SandboxSupport.problem(level) == null) {
                    referees.add(referee(manner, level));
                } else {
                    report.publishEntry("left out: level " + level + " does not work here");
                }
            }
            assertFalse(referees.isEmpty());
            for (Process referee : referees) {
                endsWithItsBots(referee, signal);
            }
        } finally {
            referees.forEach(Process::destroyForcibly);
        }
    }

    private static void endsWithItsBots(Process referee, String signal) throws Exception {
        long[] family = family(referee);
        assertTrue(family.length >= 4, Arrays.toString(family));
        if (signal != null) {
            for (long pid : family) {
                assertTrue(ScriptedBots.isRunning(pid), "not running: " + pid);
            }
            String[] kill = {"sh", "-c", "kill -s " + signal + " " + referee.pid()};
            assertTrue(new ProcessBuilder(kill).start().waitFor() == 0);
        }
        assertTrue(referee.waitFor(60, TimeUnit.SECONDS));
        Arrays.stream(family).forEach(ScriptedBots::assertGone);
    }

    @Test
    void killed(TestReporter report) throws Exception {
        endWithTheirBots(report, List.of(SandboxLevel.values()), "wait", "KILL");
    }

    @Test
    void interrupted(TestReporter report) throws Exception {
        ScriptedBots.assumeInterruptible();
        endWithTheirBots(report, List.of(SandboxLevel.OFF), "wait", "INT");
    }

    @Test
    void terminated(TestReporter report) throws Exception {
        endWithTheirBots(report, List.of(SandboxLevel.OFF), "wait", "TERM");
    }

    @Test
    @Tag("campaign")
    void exited(TestReporter report) throws Exception {
        endWithTheirBots(report, List.of(SandboxLevel.values()), "exit", null);
    }
}
