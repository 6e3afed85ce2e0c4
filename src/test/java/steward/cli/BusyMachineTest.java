package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.accounting.TreeSampler;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.cli.shared.ExitStatus;
import steward.match.TestSize;
import tools.jackson.databind.JsonNode;

/**
 * Correct programs on a machine whose processors have three times as many busy processes: none is called faulty. They
 * are {@code src/test/resources/busy}, one source for each language that is installed, and each is of seven kinds by
 * its argument. None uses more than 60% of its limit, 45 of 75 ms, or 600 of 1000 ms at its start.
 * It takes long because the load that it makes slows down the tests too.
 */
@Tag("process")
@Tag("slow")
@Tag("sized")
class BusyMachineTest {

    private static final Path SOURCES = Path.of("src/test/resources/busy");
    private static final int LOAD = 3;
    private static final List<String> KINDS = List.of("clock", "work", "sleep", "read", "start", "threads", "garbage");

    /** A language: the source, what compiles it ({@code -} for nothing), and what runs it. */
    private static final String[][] LANGUAGES = {
        {"bot.cpp", "g++ -O2 -pthread -o bot bot.cpp", "./bot"},
        {"bot.py", "-", "python3 bot.py"},
        {"Bot.java", "javac Bot.java", "java Bot"},
        {"bot.js", "-", "node bot.js"},
        {"bot.go", "go build -o bot bot.go", "./bot"},
        {"bot.rs", "rustc -O -o bot bot.rs", "./bot"},
        {"bot.pl", "-", "perl bot.pl"}};

    private static final String ANSWER = "{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}";

    private final List<Process> load = new ArrayList<>();
    /** Folders by the words that run the program in them. */
    private static final Map<Path, String> BOTS = new LinkedHashMap<>();

    @TempDir
    private static Path folder;
    private static Path scene;

    /** A program that starts is a hand-in of a tournament too. */
    @BeforeAll
    static void programs() throws IOException, InterruptedException {
        assumeTrue(ShellBots.runnable() && TreeSampler.showsCpuTime(), "there is no /bin/sh or no /proc");
        scene = folder.resolve("short.json");
        Files.writeString(scene, Files.readString(Path.of("config/scenes/duel.json")).replace("\"duel\"", "\"short\"")
            .replace("\"maximumTurns\": 200", "\"maximumTurns\": 3"));
        for (String[] language : Arrays.copyOf(LANGUAGES, TestSize.of(1, LANGUAGES.length))) {
            Path built = Files.createDirectories(folder.resolve("built").resolve(language[0]));
            Files.copy(SOURCES.resolve(language[0]), built.resolve(language[0]));
            String program = (language[1].equals("-") ? language[2] : language[1]).split(" ")[0];
            if (ProgramFinder.find(program) == null || !language[1].equals("-") && new ProcessBuilder(
                    language[1].split(" ")).directory(built.toFile()).inheritIO().start().waitFor() != 0) {
                continue;
            }
            for (String kind : TestSize.isWhole() ? KINDS : List.of(KINDS.get(BOTS.size() % KINDS.size()))) {
                add(built, language[0].replaceAll(".*\\.", "") + "-" + kind, language[2] + " " + kind);
            }
        }
        String shell = "while read -r l; do case $l in *'\"turn\"'*) sleep 0.03; echo '" + ANSWER
            + "';; esac; done";
        Files.writeString(Files.createDirectories(folder.resolve("built/sh")).resolve("bot.sh"), shell);
        add(folder.resolve("built/sh"), "sh-sleep", "sh bot.sh");
    }

    @BeforeEach
    void load() throws IOException {
        for (int k = 0; k < LOAD * Runtime.getRuntime().availableProcessors(); k++) {
            load.add(new ProcessBuilder("/bin/sh", "-c", "while :; do :; done").start());
        }
    }

    private static void add(Path built, String name, String run) throws IOException {
        Path own = Files.createDirectories(folder.resolve("in").resolve(name));
        try (var files = Files.list(built)) {
            for (Path file : files.toList()) {
                Files.copy(file, own.resolve(file.getFileName()));
            }
        }
        Files.writeString(own.resolve("run"), run);
        if (name.endsWith("-read")) {
            Files.writeString(own.resolve("big.txt"), "7 1 2 3 4\n".repeat(200_000));
        }
        BOTS.put(own, run);
    }

    @AfterEach
    void unload() throws InterruptedException {
        for (Process each : load) {
            each.destroyForcibly().waitFor();
        }
    }

    /** In campaigns one program of each language: the tournament checks all of them, in the same way. */
    @Test
    void aCorrectProgramIsNotCalledFaultyOnALoadedMachine(TestReporter report) {
        List<String> wrong = new ArrayList<>();
        int told = 0;
        List<Map.Entry<Path, String>> all = List.copyOf(BOTS.entrySet());
        int step = TestSize.of(1, KINDS.size() + 1);
        for (int k = 0; k < all.size(); k += step) {
            Map.Entry<Path, String> bot = all.get(k);
            String name = bot.getKey().getFileName().toString();
            Cli check = Cli.run("check", bot.getValue(), "--in", bot.getKey().toString(), "--scene", scene.toString());
            if (check.status() != 0) {
                wrong.add(name + ": check says " + check.out() + check.err());
            }
            Cli match = Cli.run("match", "--bot", bot.getValue(), "--in", bot.getKey().toString(), "--bot",
                "builtin:racer", "--scene", scene.toString(), "--seed", "1", "--strict", "--json");
            told += match.err().contains("played again") ? 1 : 0;
            if (match.status() != 0) {
                wrong.add(name + ": match says " + match.out() + match.err());
            }
        }
        report.publishEntry("programs", (all.size() + step - 1) / step + ", matches played again " + told);
        assertEquals(List.of(), wrong);
        assertTrue(BOTS.size() >= LANGUAGES.length || !TestSize.isWhole(), "too few languages are installed");
    }

    /** One computes without end, the other sleeps for longer than its limit: no load is their excuse. */
    @Test
    void aProgramThatIsSlowByItselfIsCalledFaultyOnALoadedMachine() throws IOException {
        for (String slow : List.of("while :; do :; done", "sleep 3")) {
            assertLate("sh " + Files.writeString(folder.resolve("slow.sh"), "read -r l; read -r l; echo '" + ANSWER
                + "'; read -r l; " + slow + "\n"));
        }
    }

    /** It answers after 400 ms. Its processes live for 3 ms, nobody waits for them: their CPU time is in no count. */
    @Test
    void aProgramThatStarvesItselfByChainsOfProcessesIsCalledFaulty() throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3");
        assumeTrue(Isolation.usual().level() != SandboxLevel.OFF, "orphans leave the tree of processes");
        assertLate("python3 " + Files.writeString(folder.resolve("chains.py"), """
            import os, signal, sys, time
            def chain():
                while True:
                    end = time.process_time() + 0.003
                    while time.process_time() < end: pass
                    if os.fork(): os._exit(0)
            sys.stdin.readline(), sys.stdin.readline(), print('%s', flush=True), sys.stdin.readline()
            signal.signal(signal.SIGCHLD, signal.SIG_IGN)
            for _ in range(2 * os.cpu_count()):
                if not os.fork(): chain()
            end = time.monotonic() + 0.4
            while time.monotonic() < end: pass
            print('%s', flush=True)
            """.formatted(ANSWER, ANSWER)));
    }

    private static void assertLate(String bot) {
        Cli match = Cli.run("match", "--bot", "slow=" + bot, "--bot", "builtin:racer", "--scene", scene.toString(),
            "--seed", "1", "--strict", "--quiet");
        assertEquals(ExitStatus.FAILED, match.status(), match.out() + match.err());
        assertTrue(match.out().contains("slow failed in turn 2: no answer within 75 ms"), match.out() + match.err());
    }

    @Test
    @Tag("campaign")
    void noneHasFailedInATournamentOnALoadedMachine(TestReporter report) {
        Cli played = Cli.run("tournament", folder.resolve("in").toString(), "--protocol", "json", "--scene",
            scene.toString(), "--rounds", "1", "--games", "1", "--json", "--page", folder.resolve("page").toString());
        assertEquals(ExitStatus.DONE, played.status(), played.out() + played.err());
        List<String> wrong = new ArrayList<>();
        for (JsonNode program : played.json().get("programs")) {
            if (!program.get("ready").booleanValue()) {
                wrong.add(program.toString());
            }
        }
        int games = 0;
        for (JsonNode score : played.json().get("scores")) {
            games += score.get("games").intValue();
            if (score.get("failed").intValue() > 0) {
                wrong.add(score.toString());
            }
        }
        report.publishEntry("tournament", BOTS.size() + " programs, " + games / 2 + " games");
        assertEquals(List.of(), wrong, played.err());
        assertTrue(games / 2 >= BOTS.size() / 2, played.out());
    }
}
