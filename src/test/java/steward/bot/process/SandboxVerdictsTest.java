package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;

/**
 * Verdicts and exit statuses are the same at every level of isolation, and whoever starts the bot in it: one table for
 * all that this machine offers.
 */
@Tag("process")
class SandboxVerdictsTest {

    private static final long SHORT = 60_000_000;
    private static final long FOREVER = ScriptedBots.FOREVER;

    /** A level, and whether a shell makes it where a small program would. */
    enum Way {
        OFF(SandboxLevel.OFF, false), LIGHT(SandboxLevel.LIGHT, false), STRICT(SandboxLevel.STRICT, false),
        LIGHT_BY_SHELL(SandboxLevel.LIGHT, true), STRICT_BY_SHELL(SandboxLevel.STRICT, true);

        private final SandboxLevel level;
        private final boolean shell;

        Way(SandboxLevel level, boolean shell) {
            this.level = level;
            this.shell = shell;
        }
    }

    /**
     * A bot that has answered once.
     *
     * @param script what it then does when it is asked again
     * @param limit  how long it may take, in nanoseconds
     * @param fault  a pattern for the verdict
     * @param came   text of the answer that is none
     */
    private record Case(String script, long limit, String fault, String came) {

        Case(String script, long limit, String fault) {
            this(script, limit, fault, "");
        }
    }

    private static final List<Case> TABLE = List.of(
        new Case("exit 0", FOREVER, "exited with status 0 before answering"),
        new Case("printf part; exit 3", FOREVER, "exited with status 3 before answering", "part"),
        new Case("exit 200", FOREVER, "exited with status 200 before answering"),
        new Case("kill -s SEGV $$", FOREVER, "killed by signal 11 \\(SIGSEGV\\) before answering"),
        new Case("kill -s INT $$", FOREVER, "killed by signal 2 \\(SIGINT\\) before answering"),
        // A JVM blocks SIGQUIT, and what it starts inherits that.
        new Case("kill -s QUIT $$", FOREVER, "exited with status 0 before answering"),
        new Case("kill -s TERM $$", FOREVER, "killed by signal 15 \\(SIGTERM\\) before answering"),
        new Case("kill -s HUP $$", FOREVER, "killed by signal 1 \\(SIGHUP\\) before answering"),
        new Case("kill -s PIPE $$", FOREVER, "killed by signal 13 \\(SIGPIPE\\) before answering"),
        new Case("kill -s KILL $$", FOREVER, "killed by signal 9 \\(SIGKILL\\) before answering"),
        new Case("kill -s KILL 0", FOREVER, "killed by signal 9 \\(SIGKILL\\) before answering"),
        new Case("trap '' TERM; kill -s TERM 0; exit 4", FOREVER, "exited with status 4 before answering"),
        new Case("exec >&-; exec sleep 1000", FOREVER, "closed its output before answering"),
        new Case("sleep 1000 & exit 5", FOREVER, "exited with status 5 before answering"),
        new Case("exec ./no-such-program-of-$$", FOREVER,
            "exited with status 127 before answering \\(127: a command was not found\\)"),
        new Case("exec /etc/passwd", FOREVER,
            "exited with status 126 before answering \\(126: a command cannot be executed\\)"),
        new Case("exec sleep 1000", SHORT, "no answer within 60 ms \\(waited [0-9]+ ms\\).*"),
        new Case("printf part; exec sleep 1000", 10 * SHORT,        // on a busy machine the part comes late
            "no answer within 600 ms \\(waited [0-9]+ ms\\).*: 4 bytes came, without a line end.*", "part"),
        new Case("kill -s STOP $$", SHORT, "no answer within 60 ms \\(waited [0-9]+ ms\\).*"),
        new Case("head -c 65537 /dev/zero | tr '\\0' x; exec sleep 1000", FOREVER, "line longer than 65536 bytes",
            "x".repeat(1024)),
        new Case("head -c 1000000 /dev/zero; exec sleep 1000", FOREVER, "line longer than 65536 bytes",
            "\0".repeat(1024)));

    private static BotProcess start(Way way, List<String> command) {
        return new BotProcess("bot", new Launch(command, Isolation.at(way.level), List.of()),
            BotProcess.DEFAULT_GRACE_MS);
    }

    private static void by(Way way, Runnable test) {
        if (way.shell) {
            SandboxProperty.withoutProgram(test);
        } else {
            test.run();
        }
    }

    /** All rows without a sandbox, and two of five by each other way. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void theTableByTurns(Way way) throws IOException {
        int first = way.ordinal();
        assertVerdicts(way, IntStream.range(0, TABLE.size())
            .filter(row -> way == Way.OFF || (row + first) % Way.values().length < 2).mapToObj(TABLE::get).toList());
    }

    @Tag("campaign")
    @ParameterizedTest
    @EnumSource(Way.class)
    void theTable(Way way) throws IOException {
        assertVerdicts(way, TABLE);
    }

    private static void assertVerdicts(Way way, List<Case> rows) throws IOException {
        ScriptedBots.assumeInterruptible();
        ScriptedBots.assumeWorks(way.level);
        by(way, () -> {
            List<String> wrong = new ArrayList<>();
            for (Case each : rows) {
                String script = "read -r l; echo ready; read -r l; " + each.script();
                try (BotProcess bot = start(way, List.of("sh", "-c", script))) {
                    assertEquals("ready", ScriptedBots.reply(bot, "a\n"));
                    List<Long> processes = bot.processes();
                    Answer answer = ScriptedBots.fault(bot, "b\n", each.limit());
                    if (!answer.fault().matches(each.fault()) || !answer.text().equals(each.came())
                        || each.limit() < FOREVER && answer.nanos() < each.limit()) {
                        wrong.add(each.script() + ": " + answer.fault() + ": " + answer.text());
                    }
                    processes.forEach(ScriptedBots::assertGone);
                }
            }
            assertEquals(List.of(), wrong);
        });
    }

    @ParameterizedTest
    @EnumSource(Way.class)
    void aCommandThatIsNotThere(Way way, @TempDir Path folder) {
        ScriptedBots.assumeWorks(way.level);
        by(way, () -> {
            try (BotProcess bot = start(way, List.of(folder + "/no/bot"))) {
                Answer answer = ScriptedBots.fault(bot, "a\n", FOREVER);
                assertEquals("exited with status 127 before answering (127: a command was not found)", answer.fault());
                assertTrue(answer.stderr().contains(folder + "/no/bot"), answer.stderr());
            }
            try (BotProcess bot = start(way, List.of("/etc/passwd"))) {
                assertEquals("exited with status 126 before answering (126: a command cannot be executed)",
                    ScriptedBots.fault(bot, "a\n", FOREVER).fault());
            }
        });
    }

    /** Things that a bot may do: close its input, write to stderr, leave children behind that write on. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void goodAnswers(Way way) {
        ScriptedBots.assumeWorks(way.level);
        by(way, () -> {
            BotProcess bot = start(way, List.of("sh", "-c", "read -r l; echo said >&2; echo \"$l\"; exec <&-; echo 2;"
                + " while ! read -r l; do sleep 1000; done 2>/dev/null"));
            Answer answer = ScriptedBots.answer(bot, "one\n", 1);
            assertEquals("one", answer.text());
            assertEquals("said\n", answer.stderr());
            assertEquals("2", ScriptedBots.reply(bot, "two\n"));
            List<Long> processes = bot.processes();
            bot.close();
            processes.forEach(ScriptedBots::assertGone);
        });
    }

    /** The end line is read before the end of the input, and what is said then is kept. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void theEnd(Way way) {
        ScriptedBots.assumeWorks(way.level);
        by(way, () -> {
            BotProcess bot = new BotProcess("bot", new Launch(List.of("sh", "-c",
                "while read -r l; do echo \"$l\"; last=$l; done; echo \"$last and over\" >&2"),
                Isolation.at(way.level), List.of()), 60_000);
            assertEquals("one", ScriptedBots.reply(bot, "one\n"));
            ScriptedBots.finish(bot, "end\n");
            assertEquals("end and over\n", bot.finalStderr());
        });
    }

    /** As without a sandbox. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void descriptorsAndIgnoredSignalsAreThoseOfAnyProgram(Way way) throws IOException {
        ScriptedBots.assumeInterruptible();
        ScriptedBots.assumeWorks(way.level);
        List<String> command = List.of("sh", "-c",
            "read -r l; ls /proc/$$/fd; grep SigIgn /proc/self/status; echo .; exec sleep 1000");
        try (BotProcess plain = start(Way.OFF, command)) {
            String expected = ScriptedBots.answer(plain, "a\n", 5).text();
            assertTrue(expected.startsWith("0\n1\n2\nSigIgn:"), expected);
            by(way, () -> {
                try (BotProcess bot = start(way, command)) {
                    assertEquals(expected, ScriptedBots.answer(bot, "a\n", 5).text());
                }
            });
        }
    }

    /** One that is stopped while it waits still plays, and ends. */
    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void aBotThatIsPausedWhileItWaits(SandboxLevel level) {
        ScriptedBots.assumeWorks(level);
        Isolation pausing = Isolation.at(level).holding(HoldPolicy.ALWAYS);
        BotProcess bot = new BotProcess("bot", new Launch(List.of("sh", "-c",
            "read -r l; n=0; while :; do n=$((n + 1)); done & echo 0; while read -r l; do echo \"$l\"; done; kill $!"),
            pausing, List.of()), 60_000);
        assertEquals("0", timed(bot, "start\n"));
        // The shell and its child, which may not have computed at all yet.
        ScriptedBots.await("it is not stopped", () -> bot.processes().stream().filter(ScriptedBots::isHalted)
            .count() >= 2);
        for (int turn = 0; turn < 20; turn++) {
            assertEquals("turn " + turn, timed(bot, "turn " + turn + "\n"));
        }
        List<Long> processes = bot.processes();
        bot.close();
        processes.forEach(ScriptedBots::assertGone);
    }

    /** Both have the same number in their namespaces, by which a JVM names a file in /tmp and locks it. */
    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void aJvmBesideAnotherSaysNothingOfItsOwn(SandboxLevel level, @TempDir Path folder) throws IOException {
        ScriptedBots.assumeWorks(level);
        assumeTrue(level != SandboxLevel.LIGHT || HoldMeans.of(Isolation.at(level)) == HoldMeans.INIT,
            "skipped: there is no C compiler");
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this is no JDK");
        Path program = Files.writeString(folder.resolve("Echo.java"), "class Echo { public static void main(String[] a)"
            + " throws Exception { System.in.transferTo(System.out); } }");
        assertEquals(0, compiler.run(null, null, null, program.toString()));
        List<String> command = List.of(ProcessHandle.current().info().command().orElseThrow(), "-Xint", "-cp",
            folder.toString(), "Echo");
        List<BotProcess> bots = new ArrayList<>();
        try {
            for (int k = 0; k < 2; k++) {
                bots.add(new BotProcess("bot", new Launch(command, Isolation.at(level), List.of()), 0));
                assertEquals("one", ScriptedBots.reply(bots.get(k), "one\n"));
            }
        } finally {
            bots.forEach(Player::close);
        }
    }

    /** The reply within a limit: without one, bots are not held. */
    private static String timed(BotProcess bot, String frame) {
        Answer answer = new Answer();
        byte[] bytes = frame.getBytes(StandardCharsets.UTF_8);
        bot.ask(bytes, bytes.length, 1, TimeUnit.SECONDS.toNanos(20), answer);
        return answer.text();
    }

    /** Started with the first answer, as the match does. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void playersEndWithTheirMatch(Way way) {
        ScriptedBots.assumeWorks(way.level);
        by(way, () -> {
            List<Player> bots = new ArrayList<>();
            List<Long> processes = new ArrayList<>();
            for (int k = 0; k < 6; k++) {
                BotProcess bot = start(way, List.of("sh", "-c", "sleep 1000 & exec cat"));
                assertEquals("x", ScriptedBots.reply(bot, "x\n"));
                processes.addAll(bot.processes());
                bots.add(bot);
            }
            bots.forEach(Player::close);
            processes.forEach(ScriptedBots::assertGone);
        });
    }
}
