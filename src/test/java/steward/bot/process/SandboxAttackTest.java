package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.ControlGroup;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;

/**
 * Bots that attack their opponent and this machine, at every level of isolation that works here. The table held is that
 * of {@code docs/tables/sandbox.md}; an attack that succeeds at level off shows that it is one.
 */
@Tag("process")
class SandboxAttackTest {

    private static final String PAGE = "docs/tables/sandbox.md";

    /** The processes of the opponent, to be replaced. */
    private static final String OPPONENT = "OPPONENT";

    /** Needs of an attack. */
    private record Field(BotProcess opponent, List<Long> processes, SandboxLevel level, Path folder) {

        /** Runs a script that attacks; whether it says so itself. */
        boolean says(String script) {
            return says(script, () -> { });
        }

        boolean says(String script, Runnable meanwhile) {
            String all = processes.stream().map(String::valueOf).collect(Collectors.joining(" "));
            String code = "read -r l; { " + script.replace(OPPONENT, all)
                + "; } >/dev/null 2>&1 && echo yes || echo no;"
                + " read -r l";
            try (BotProcess attacker = ScriptedBots.bot(code, level)) {
                String answer = ScriptedBots.reply(attacker, "go\n");
                meanwhile.run();
                return answer.equals("yes");
            }
        }

        boolean opponentRuns() {
            return processes.stream().allMatch(ScriptedBots::isRunning);
        }
    }

    /** One attack; true if it succeeded. */
    private interface Attack {
        boolean succeeds(Field field) throws Exception;
    }

    private static final Map<String, Attack> ATTACKS = new LinkedHashMap<>();

    static {
        ATTACKS.put("reads what its opponent is sent, through `/proc`",
            field -> field.says(some("[ -e /proc/$p/fd/0 ]")));
        ATTACKS.put("answers in its opponent's place, through `/proc`", field -> field.says(some(
            "{ echo forged >/proc/$p/fd/1; }")) && ScriptedBots.reply(field.opponent, "honest\n").equals("forged"));
        ATTACKS.put("reads its opponent's environment", field -> field.says(some("cat /proc/$p/environ")));
        ATTACKS.put("uncovers the processes of the machine by unmounting its `/proc`", SandboxAttackTest::uncovers);
        ATTACKS.put("stops its opponent", field -> {
            field.says("kill -s STOP OPPONENT");
            if (field.level == SandboxLevel.OFF) {
                ScriptedBots.await("it was not stopped", () -> ScriptedBots.isHalted(field.processes.get(0)));
            }
            boolean stopped = field.processes.stream().anyMatch(ScriptedBots::isHalted);
            field.processes.forEach(pid -> signal("CONT", pid));
            return stopped;
        });
        ATTACKS.put("kills its opponent", field -> {
            field.says("kill -s KILL OPPONENT");
            if (field.level == SandboxLevel.OFF) {
                ScriptedBots.await("it was not killed", () -> !field.opponentRuns());
            }
            return !field.opponentRuns();
        });
        ATTACKS.put("leaves processes behind that have left its session", SandboxAttackTest::leavesProcesses);
        ATTACKS.put("gets rights by a setuid program", field -> field.says("grep 'NoNewPrivs:.0' /proc/self/status"));
        ATTACKS.put("reaches servers on this machine and elsewhere", SandboxAttackTest::connects);
        ATTACKS.put("sees what others keep in `/dev/shm`", SandboxAttackTest::seesSharedMemory);
        ATTACKS.put("reads your files", SandboxAttackTest::readsHome);
        ATTACKS.put("changes your files", field -> {
            Path file = field.folder.resolve("written-" + field.level.word());
            field.says("echo x >'" + file + "'");
            return Files.exists(file);
        });
    }

    /** Returns a script that tries something on one of the opponent's processes, {@code $p}. */
    private static String some(String what) {
        return "for p in " + OPPONENT + "; do " + what + " && ok=1; done; [ \"$ok\" ]";
    }

    /** Nothing is unmounted at level off: that would be the machine's own. */
    private static boolean uncovers(Field field) {
        String seen = some("[ -d /proc/$p ]");
        return field.says(field.level == SandboxLevel.OFF ? seen
            : "umount /proc; { " + seen + "; } || unshare -Urm sh -c 'umount /proc; " + seen + "'");
    }

    private static boolean leavesProcesses(Field field) throws Exception {
        String mark = "1000." + Long.toUnsignedString(System.nanoTime());
        List<Long> seen = new ArrayList<>();
        field.says("(setsid sh -c '(setsid sleep " + mark + " &)') </dev/null", () -> {
            ScriptedBots.await("it was not started", () -> !sleeping(mark).isEmpty());
            seen.addAll(sleeping(mark));
        });
        if (field.level != SandboxLevel.OFF) {
            seen.forEach(ScriptedBots::assertGone);
        }
        List<Long> left = sleeping(mark);
        left.forEach(pid -> signal("KILL", pid));
        return !left.isEmpty();
    }

    private static List<Long> sleeping(String mark) {
        List<Long> found = new ArrayList<>();
        try (DirectoryStream<Path> all = Files.newDirectoryStream(Path.of("/proc"), "[0-9]*")) {
            for (Path process : all) {
                if (commandLine(process).equals("sleep\0" + mark + "\0")) {
                    found.add(Long.parseLong(process.getFileName().toString()));
                }
            }
            return found;
        } catch (IOException problem) {
            throw new AssertionError(problem);
        }
    }

    private static String commandLine(Path process) {
        try {
            return Files.readString(process.resolve("cmdline"), StandardCharsets.ISO_8859_1);
        } catch (IOException ended) {
            return "";
        }
    }

    private static boolean connects(Field field) throws IOException {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
            return field.says("bash -c 'exec 3<>/dev/tcp/127.0.0.1/" + server.getLocalPort() + "'");
        }
    }

    private static boolean seesSharedMemory(Field field) throws IOException {
        Path kept = Files.createTempFile(Path.of("/dev/shm"), "steward-test-", ".txt");
        try {
            return field.says("[ -e '" + kept + "' ] || ! echo x >/dev/shm/own");
        } finally {
            Files.delete(kept);
        }
    }

    private static boolean readsHome(Field field) throws IOException {
        Path secret = Files.createTempFile(Path.of(System.getProperty("user.home")), ".steward-test-", ".txt");
        try {
            Files.writeString(secret, "secret");
            return field.says("[ \"$(cat '" + secret + "')\" = secret ]");
        } finally {
            Files.delete(secret);
        }
    }

    private static void signal(String name, long pid) {
        try {
            new ProcessBuilder("sh", "-c", "kill -s " + name + " " + pid).redirectErrorStream(true).start().waitFor();
        } catch (IOException | InterruptedException problem) {
            throw new AssertionError(problem);
        }
    }

    /** The rows of the page: by attack, the words of the columns off, light and strict. */
    private static Map<String, List<String>> page() throws IOException {
        Map<String, List<String>> rows = new LinkedHashMap<>();
        for (String line : Files.readAllLines(Path.of(PAGE))) {
            String[] cells = line.split("\\|");
            if (cells.length == 5 && cells[2].strip().matches("yes|no")) {
                rows.put(cells[1].strip(), List.of(cells[2].strip(), cells[3].strip(), cells[4].strip()));
            }
        }
        return rows;
    }

    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void theTableOfThePage(SandboxLevel level, @TempDir Path folder, TestReporter reporter) throws Exception {
        ScriptedBots.assumeWorks(level);
        assumeTrue(ProgramFinder.find("bash") != null, "skipped: there is no bash, which connects to a server");
        assumeTrue(Files.readString(Path.of("/proc/self/status")).contains("NoNewPrivs:\t0"),
            "skipped: no program gets rights here anyway");
        Map<String, String> expected = new LinkedHashMap<>();
        page().forEach((attack, cells) -> expected.put(attack, cells.get(level.ordinal())));
        Map<String, String> found = new LinkedHashMap<>();
        for (Map.Entry<String, Attack> attack : ATTACKS.entrySet()) {
            try (BotProcess opponent = ScriptedBots.bot("while read -r l; do echo \"$l\"; done", level)) {
                assertEquals("ready", ScriptedBots.reply(opponent, "ready\n"));
                Field field = new Field(opponent, opponent.processes(), level, folder);
                assertTrue(field.opponentRuns());
                found.put(attack.getKey(), attack.getValue().succeeds(field) ? "yes" : "no");
            }
        }
        found.forEach((attack, outcome) -> reporter.publishEntry(level.word() + ": " + attack, outcome));
        assertEquals(expected, found);
    }

    /** It could end the namespace, or keep it alive when the match is over. SEIZE, unlike ATTACH, stops nothing. */
    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    @SuppressWarnings("try")                           // closed before the end, to see what is left
    void theFirstProcessCannotBeTakenOver(SandboxLevel level) {
        ScriptedBots.assumeWorks(level);
        assumeTrue(SandboxSupport.isNative(), "skipped: there is no C compiler, so that a shell is the first process");
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        String attach = "import ctypes, sys; libc = ctypes.CDLL(None); "
            + "print(libc.ptrace(0x4206, int(sys.argv[1]), 0, 0), flush=True)";
        String script = "read -r l; python3 -c '" + attach + "' 1; kill -s KILL 1; kill -s TERM 1; kill -s STOP 1;"
            + " read -r l; echo alive; read -r l";
        try (BotProcess bot = new BotProcess("bot", new Launch(List.of("sh", "-c", script),
                visiblePython(level), List.of()), BotProcess.DEFAULT_GRACE_MS)) {
            assertEquals("-1", ScriptedBots.reply(bot, "a\n"), "attached to the first process");
            assertEquals("alive", ScriptedBots.reply(bot, "b\n"));
            List<Long> processes = bot.processes();
            bot.close();
            processes.forEach(ScriptedBots::assertGone);
        }
    }

    /** As the filter of system calls does: each alone is enough. */
    @Test
    void theKernelRefusesNamespacesWithinThoseOfABot() {
        ScriptedBots.assumeWorks(SandboxLevel.LIGHT);
        assumeTrue(SandboxSupport.isNative(), "skipped: there is no C compiler, so that a shell makes the namespaces");
        String script = "read -r l; cat /proc/sys/user/max_user_namespaces; read -r l";
        try (BotProcess bot = ScriptedBots.bot(script, SandboxLevel.LIGHT)) {
            assertEquals("0", ScriptedBots.reply(bot, "a\n"));
        }
    }

    /** There it could kill and stop an opponent that has a group of its own, or leave its own and not be paused. */
    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void controlGroupsCannotBeWrittenTo(SandboxLevel level) throws InterruptedException {
        ScriptedBots.assumeWorks(level);
        assumeTrue(SandboxSupport.isNative(), "skipped: there is no C compiler, so that bots have no groups at light");
        assumeTrue(ControlGroup.problem() == null, "skipped: " + ControlGroup.problem());
        String mounts = "while read -r d p t o; do case $t in cgroup*) [ -w $p/cgroup.procs ] && ok=1;; esac; done"
            + " </proc/mounts; [ \"$ok\" ]";
        String script = "read -r l; { " + mounts + "; } && echo yes || echo no; read -r l;"
            + " unshare -UrmC sh -c 'mount -t cgroup2 none /mnt && [ -w /mnt/cgroup.procs ]' 2>/dev/null"
            + " && echo yes || echo no; read -r l";
        Isolation pausing = Isolation.at(level).holding(HoldPolicy.ALWAYS);
        try (BotProcess bot = new BotProcess("bot", new Launch(List.of("sh", "-c", script), pausing, List.of()),
                BotProcess.DEFAULT_GRACE_MS)) {
            assertEquals("no", ScriptedBots.reply(bot, "a\n"), "writes to control groups");
            if (level == SandboxLevel.LIGHT || ProgramTrial.of(List.of("bwrap", "--unshare-user", "--disable-userns",
                    "--ro-bind", "/", "/", "true"), 60_000).works()) {
                assertEquals("no", ScriptedBots.reply(bot, "b\n"), "mounts control groups again");
            }
        }
    }

    private static Isolation visiblePython(SandboxLevel level) {
        Isolation usual = Isolation.at(level);
        Path prefix = ProgramFinder.find("python3").toAbsolutePath().getParent().getParent();
        return new Isolation(level, false, usual.limits(), usual.environment(), List.of(prefix), List.of(),
            HoldPolicy.BURNERS);
    }

    /** A bot that signals its own group with what kills it at once ends itself, and takes nobody with it. */
    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void aBotThatKillsItsGroupKillsOnlyItself(SandboxLevel level) {
        ScriptedBots.assumeWorks(level);
        try (BotProcess opponent = ScriptedBots.bot("while read -r l; do echo \"$l\"; done", level)) {
            assertEquals("ready", ScriptedBots.reply(opponent, "ready\n"));
            try (BotProcess bot = ScriptedBots.bot("read -r l; sleep 1000 & kill -s KILL 0", level)) {
                assertEquals("killed by signal 9 (SIGKILL) before answering",
                    ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).fault());
                bot.processes().forEach(ScriptedBots::assertGone);
            }
            assertEquals("still", ScriptedBots.reply(opponent, "still\n"));
            assertFalse(opponent.processes().isEmpty());
        }
    }
}
