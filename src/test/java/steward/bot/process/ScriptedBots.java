package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;

/** Bots for tests, written as shell scripts, and how tests talk to them and look whether they are still there. */
public final class ScriptedBots {

    /** Bits of the signals in a mask of the system. */
    private static final long HUP_AND_INT = 3;

    /** No deadline. */
    public static final long FOREVER = Long.MAX_VALUE;

    /** Where the time of a missed deadline went, or that it is not shown. */
    public static final String PARTS = "(computed .*|the machine was busy: .*|this system does not show .*)";

    /** Time that a loaded machine may need for something that takes milliseconds. */
    private static final long PATIENCE_NANOS = 30_000_000_000L;

    private ScriptedBots() {
    }

    public static void assumeShell() {
        assumeTrue(ProgramFinder.find("sh") != null, "there is no sh on the PATH");
    }

    static void assumeGroups() {
        assumeShell();
        assumeTrue(ProgramFinder.find("setsid") != null, "there is no setsid on the PATH");
        assumeTrue(Files.isDirectory(Path.of("/proc/self")), "there is no /proc");
    }

    /**
     * A process that a shell started in the background ignores Ctrl-C, and one that nohup started the end of its
     * terminal; so do the processes that it starts.
     */
    public static void assumeInterruptible() throws IOException {
        Path status = Path.of("/proc/self/status");
        assumeTrue(Files.exists(status), "there is no /proc");
        assumeTrue(Files.readAllLines(status).stream().filter(line -> line.startsWith("SigIgn:"))
            .map(line -> Long.parseUnsignedLong(line.substring("SigIgn:".length()).strip(), 16))
            .noneMatch(mask -> (mask & HUP_AND_INT) != 0),
            "this process ignores the signal of Ctrl-C, or that of a terminal that closes");
    }

    static BotProcess bot(String script) {
        return new BotProcess("bot", List.of("sh", "-c", script));
    }

    /** A bot at a level of isolation. */
    static BotProcess bot(String script, SandboxLevel level) {
        return new BotProcess("bot", new Launch(List.of("sh", "-c", script), Isolation.at(level), List.of()),
            BotProcess.DEFAULT_GRACE_MS);
    }

    static void assumeWorks(SandboxLevel level) {
        assumeGroups();
        String problem = SandboxSupport.problem(level);
        assumeTrue(problem == null, "skipped: level " + level.word() + " does not work here: " + problem);
    }

    public static void tell(Player player, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        player.tell(bytes, bytes.length);
    }

    public static Player.Ending ask(Player player, String frame, int lines, long limitNanos, Answer answer) {
        byte[] bytes = frame.getBytes(StandardCharsets.UTF_8);
        return player.ask(bytes, bytes.length, lines, limitNanos, answer);
    }

    /** Asks without a deadline for lines that have to come. */
    public static Answer answer(Player player, String frame, int lines) {
        Answer answer = new Answer();
        Player.Ending ending = ask(player, frame, lines, FOREVER, answer);
        assertEquals(Player.Ending.ANSWERED, ending, () -> answer.fault() + " " + answer.stderr());
        return answer;
    }

    /** Asks for one line that has to come. */
    public static String reply(Player player, String frame) {
        return answer(player, frame, 1).text();
    }

    /** Asks for one line; the player has to fail. */
    public static Answer fault(Player player, String frame, long limitNanos) {
        Answer answer = new Answer();
        assertEquals(Player.Ending.FAULT, ask(player, frame, 1, limitNanos, answer), answer::text);
        return answer;
    }

    public static void finish(Player player, String frame) {
        byte[] bytes = frame.getBytes(StandardCharsets.UTF_8);
        player.finish(bytes, bytes.length);
    }

    /** True if a process is there and not just waiting for its parent to take note of its end. */
    static boolean isRunning(long pid) {
        try {
            String stat = Files.readString(Path.of("/proc/" + pid + "/stat"), StandardCharsets.ISO_8859_1);
            char state = stat.charAt(stat.lastIndexOf(')') + 2);
            return state != 'Z' && state != 'X';
        } catch (IOException e) {
            return false;
        }
    }

    /** True if a process is stopped by a signal or frozen. */
    static boolean isHalted(long pid) {
        try {
            String stat = Files.readString(Path.of("/proc/" + pid + "/stat"), StandardCharsets.ISO_8859_1);
            boolean stopped = stat.charAt(stat.lastIndexOf(')') + 2) == 'T';
            Path events = Path.of("/proc/" + pid + "/cgroup");
            for (String line : Files.readAllLines(events)) {
                if (line.startsWith("0::/") && line.contains("steward-")) {
                    Path root = Files.exists(Path.of("/sys/fs/cgroup/unified"))
                        ? Path.of("/sys/fs/cgroup/unified") : Path.of("/sys/fs/cgroup");
                    Path group = root.resolve(line.substring("0::/".length())).resolve("cgroup.events");
                    return stopped || Files.readString(group).contains("frozen 1");
                }
            }
            return stopped;
        } catch (IOException e) {
            return false;
        }
    }

    public static void assertGone(long pid) {
        await("process " + pid + " is still there", () -> !isRunning(pid));
    }

    static void await(String otherwise, BooleanSupplier condition) {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!condition.getAsBoolean() && System.nanoTime() < end) {
            try {
                Thread.sleep(5);
            } catch (InterruptedException e) {
                throw new AssertionError(otherwise, e);
            }
        }
        assertTrue(condition.getAsBoolean(), otherwise);
    }
}
