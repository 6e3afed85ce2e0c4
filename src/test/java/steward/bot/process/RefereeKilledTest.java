package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.Internal;
import steward.bot.isolation.SandboxLevel;

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

    private static void endsWithItsBots(SandboxLevel level, String manner, String signal) throws Exception {
        ScriptedBots.assumeWorks(level);
        Process referee = referee(manner, level);
        try {
            endsWithItsBots(referee, signal);
        } finally {
            referee.destroyForcibly();
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

    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void killed(SandboxLevel level) throws Exception {
        endsWithItsBots(level, "wait", "KILL");
    }

    @Test
    void interrupted() throws Exception {
        ScriptedBots.assumeInterruptible();
        endsWithItsBots(SandboxLevel.OFF, "wait", "INT");
    }

    @Test
    void terminated() throws Exception {
        endsWithItsBots(SandboxLevel.OFF, "wait", "TERM");
    }

    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void exited(SandboxLevel level) throws Exception {
        endsWithItsBots(level, "exit", null);
    }
}
