package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import steward.bot.Answer;
import steward.bot.Burner;
import steward.bot.FaultMessages;
import steward.bot.Player;
import steward.bot.command.ProgramFinder;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;

/** Bots that compute while others are asked, with the program of {@code gradle fair}. */
@Tag("process")
@Timeout(240)
class BotHoldTest {

    private static final long LIMIT = TimeUnit.SECONDS.toNanos(60);
    private static final long OPPONENTS_TURN = TimeUnit.MILLISECONDS.toNanos(70);

    @TempDir
    private static Path folder;

    private static BotProcess hog(SandboxLevel level, String word, HoldPolicy policy) throws Exception {
        ScriptedBots.assumeWorks(level);
        Isolation isolation = Isolation.at(level).holding(policy);
        assumeTrue(HoldMeans.of(isolation.holding(HoldPolicy.ALWAYS)) == HoldMeans.INIT,
            "skipped: there is no C compiler");
        return new BotProcess("hog", new Launch(List.of(program(), word), isolation, List.of()), 1000);
    }

    /** Path of the program, which the first test compiles. */
    private static String program() throws IOException, InterruptedException {
        assumeTrue(ProgramFinder.find("cc") != null, "skipped: there is no C compiler");
        Path program = folder.resolve("hog");
        if (Files.exists(program)) {
            return program.toString();
        }
        assertEquals(0, new ProcessBuilder("cc", "-O1", "-o", program.toString(), "src/test/hostile/hog.c")
            .inheritIO().start().waitFor());
        return program.toString();
    }

    private static boolean ask(Player bot) {
        Answer answer = new Answer();
        Player.Ending ending = ScriptedBots.ask(bot, "turn\n", 1, LIMIT, answer);
        assertEquals(Player.Ending.ANSWERED, ending, () -> answer.fault() + " " + answer.stderr());
        return answer.held();
    }

    /** Asked three times: what burns is started with the second turn, after a line of setup. */
    private static void begin(BotProcess bot) {
        ScriptedBots.tell(bot, "setup\n");
        for (int turn = 1; turn <= 3; turn++) {
            assertFalse(ask(bot));
        }
    }

    private static boolean allHalted(BotProcess bot) {
        List<Long> processes = bot.processes();
        return processes.size() > 3 && processes.stream().filter(ScriptedBots::isHalted).count() > 1;
    }

    @ParameterizedTest
    @CsvSource({"LIGHT, hogs", "STRICT, forks", "LIGHT, sigcont", "LIGHT, namespaces", "LIGHT, pulse",
        "LIGHT, chain-4-2", "STRICT, lost-1-1"})
    void aBotThatComputesWhileOthersAreAskedIsHeld(SandboxLevel level, String word) throws Exception {
        assertHeld(level, word);
    }

    @Tag("campaign")
    @ParameterizedTest
    @CsvSource({"STRICT, hogs", "LIGHT, many", "LIGHT, forks", "LIGHT, memory", "STRICT, sigcont",
        "STRICT, chain-1-1", "LIGHT, chain-16-20", "LIGHT, lost-4-5", "STRICT, lost-16-2"})
    void aBotThatComputesInMoreWaysIsHeld(SandboxLevel level, String word) throws Exception {
        assertHeld(level, word);
    }

    /** It is held from the first answer after it was found, goes on when it is asked, and is stopped again. */
    private static void assertHeld(SandboxLevel level, String word) throws Exception {
        try (BotProcess bot = hog(level, word, HoldPolicy.BURNERS)) {
            begin(bot);
            ScriptedBots.await("it is not stopped", () -> allHalted(bot));
            for (int turn = 0; turn < 3; turn++) {
                assertTrue(ask(bot));
                ScriptedBots.await("it goes on after its answer", () -> allHalted(bot));
            }
            List<Long> processes = bot.processes();
            bot.close();
            processes.forEach(ScriptedBots::assertGone);
        }
    }

    /** First process of its namespace in this machine's numbers: the child of the one that waits outside. */
    private static long init(BotProcess bot) {
        return bot.processes().get(1);
    }

    /** Nothing that can be set of the first process keeps it from holding the bot: here from outside, by its user. */
    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void limitsOfTheFirstProcessDoNotKeepItFromHolding(SandboxLevel level) throws Exception {
        assumeTrue(ProgramFinder.find("prlimit") != null, "skipped: there is no prlimit");
        try (BotProcess bot = hog(level, "none", HoldPolicy.ALWAYS)) {
            ScriptedBots.tell(bot, "setup\n");
            ask(bot);
            for (String resource : List.of("--nofile", "--sigpending", "--nproc", "--as", "--memlock")) {
                assertEquals(0, new ProcessBuilder("prlimit", "--pid", "" + init(bot), resource + "=0").inheritIO()
                    .start().waitFor());
            }
            for (int turn = 0; turn < 3; turn++) {
                assertTrue(ask(bot));
                ScriptedBots.await("it goes on after its answer",
                    () -> bot.processes().stream().anyMatch(ScriptedBots::isHalted));
            }
        }
    }

    /** A first process that does not answer costs the match one wait, not one for each turn. */
    @Tag("campaign")
    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void aBotWhoseFirstProcessDoesNotAnswerFails(SandboxLevel level) throws Exception {
        try (BotProcess bot = hog(level, "none", HoldPolicy.ALWAYS)) {
            ScriptedBots.tell(bot, "setup\n");
            ask(bot);
            assertEquals(0, new ProcessBuilder("kill", "-STOP", "" + init(bot)).start().waitFor());
            assertEquals(FaultMessages.LOST, ScriptedBots.fault(bot, "turn\n", LIMIT).fault());
        }
    }

    /** Its children burn from 5 ms after each of its answers on, for 65 ms: it is seen over two of its waits. */
    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void aBotWhoseChildrenWaitUntilTheOtherIsAskedIsHeld(SandboxLevel level) throws Exception {
        try (BotProcess bot = hog(level, "sleeper", HoldPolicy.BURNERS)) {
            begin(bot);
            AtomicBoolean held = new AtomicBoolean();
            AtomicLong answered = new AtomicLong(Watchdog.now());
            ScriptedBots.await("it is not held", () -> {
                if (!held.get() && Watchdog.now() - answered.get() > OPPONENTS_TURN) {
                    held.set(ask(bot));
                    answered.set(Watchdog.now());
                }
                return held.get();
            });
            ScriptedBots.await("it is not stopped", () -> allHalted(bot));
        }
    }

    /** A loss beside it says nothing unless it was held from the beginning of that question. */
    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void aBurnerIsNamedUnlessItWasHeld(SandboxLevel level) throws Exception {
        try (BotProcess bot = hog(level, "hogs", HoldPolicy.BURNERS)) {
            begin(bot);
            long begun = Watchdog.now();
            ScriptedBots.await("it is not stopped", () -> allHalted(bot));
            Burner burner = bot.burner(Watchdog.now() - begun);
            assertNotNull(burner);
            assertTrue(burner.holdable());
            assertTrue(burner.processors() > 0.25, "used " + burner.processors());
            assertNull(bot.burner(0), "it is held by now");
        }
    }

    /** Its timers send it SIGCONT: stopping it is of little use, and that is said. */
    @ParameterizedTest
    @EnumSource(names = {"BURNERS", "ALWAYS"})
    void aBotThatLetsItselfGoOnIsNamedAsOneThatCannotBeHeld(HoldPolicy policy) throws Exception {
        try (BotProcess bot = hog(SandboxLevel.LIGHT, "timer", policy)) {
            ScriptedBots.tell(bot, "setup\n");
            ask(bot);
            ask(bot);
            ScriptedBots.await("it is not seen", () -> {
                Burner burner = bot.burner(0);
                return burner != null && !burner.holdable();
            });
        }
    }

    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void aBotThatOnlyAnswersIsNeverHeld(SandboxLevel level) throws Exception {
        try (BotProcess bot = hog(level, "none", HoldPolicy.BURNERS)) {
            begin(bot);
            for (int turn = 0; turn < 100; turn++) {
                assertFalse(ask(bot));
            }
            assertNull(bot.burner(LIMIT));
        }
    }

    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void withoutAPolicyItThinksOn(SandboxLevel level) throws Exception {
        try (BotProcess bot = hog(level, "hogs", HoldPolicy.NEVER)) {
            begin(bot);
            assertFalse(allHalted(bot));
            assertNull(bot.burner(LIMIT));
        }
    }

    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void alwaysHoldsAnHonestBotToo(SandboxLevel level) throws Exception {
        try (BotProcess bot = hog(level, "none", HoldPolicy.ALWAYS)) {
            ScriptedBots.tell(bot, "setup\n");
            for (int turn = 0; turn < 50; turn++) {
                assertTrue(ask(bot));
                ScriptedBots.await("it is not stopped", () -> bot.processes()
                    .stream().anyMatch(ScriptedBots::isHalted));
            }
        }
    }
}
