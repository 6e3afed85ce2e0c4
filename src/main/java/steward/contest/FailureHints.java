package steward.contest;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import steward.bot.Burner;
import steward.bot.FaultMessages;
import steward.bot.TimeSpent;
import steward.bot.command.CommandLine;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.match.Protocol;
import steward.text.TextFormat;

/** Hints for beginners: the likely cause of a bot's failure, guessed from how it failed. */
final class FailureHints {

    static final String FLUSH = "nothing ever came on its stdout; does it flush after every answer, and start in time?";
    static final String CODINGAME = "it was sent JSON; is it a CodinGame bot? then write codingame: before its command";
    static final String JSON = "it was sent CodinGame's lines; does it speak JSON? then write json: before its command";
    static final String NOT_FOUND = "a program was not found: the command itself, one that it calls, or the "
        + "interpreter in the first line of a script (#!), where a Windows line end would become part of its name";
    static final String NOT_EXECUTABLE = "a program could not be executed: without permission (chmod +x), or on a "
        + "folder that is mounted noexec; name its interpreter before it";
    static final String STARVED = "other programs used the processors while it waited for one; --time cpu does not "
        + "charge a bot for that";

    static final String LIGHT = "it failed at once, in a sandbox without network and without sight of other processes; "
        + "does it run with --sandbox off?";
    static final String STRICT = "it failed at once, in a sandbox that shows system programs, its interpreter and its "
        + "own folder, and allows no writing; --visible FOLDER lets it read more; does it run with --sandbox light?";
    static final String LOCALE = "without a locale of UTF-8 Java finds no classes below a folder whose name is not "
        + "ASCII, and bots get the locale that was set: set LC_ALL=C.UTF-8 before the call";
    static final String MEMORY = "it may have needed more memory than --memory allows";

    private static final int NOT_EXECUTABLE_STATUS = 126;
    private static final int NOT_FOUND_STATUS = 127;

    /** Messages that state by themselves why a program did not start. */
    private static final Pattern CLEAR = Pattern.compile("SyntaxError|IndentationError|ModuleNotFoundError|ImportError"
        + "|No such file|can't open|cannot open|ClassNotFound|Could not find or load|command not found|not found$");

    /** Words of systems and libraries for what a file denies, with which a line has to name it. */
    private static final Pattern DENIED = Pattern.compile("Permission denied|Operation not permitted|No such file"
        + "|NoSuchFile|FileNotFound|AccessDenied|EACCES|ENOENT|EPERM|[Cc]annot find");
    private static final Pattern READ_ONLY = Pattern.compile("Read-only file system|EROFS|ReadOnlyFileSystem");
    private static final Pattern PATH = Pattern.compile("(?<![\\w.])/[^\\s\\x00'\"`:;,()<>\\[\\]{}]+");
    /** Where there is no network. */
    private static final Pattern UNREACHABLE = Pattern.compile("[Nn]etwork is unreachable|ENETUNREACH|EAI_AGAIN"
        + "|ENOTFOUND|[Nn]ame or service not known|name resolution|UnknownHostException");

    /** Where a program says with a traceback why it ended: a parser met JSON, or did not find its number. */
    private static final Pattern TRACEBACK = Pattern.compile("Traceback \\(most recent call last\\)"
        + "|^Exception in thread|^\\s+at .+[(:]\\S*\\d+\\)?$|^panicked at|^thread '.*' panicked");
    private static final Pattern OF_INPUT = Pattern.compile("ValueError|not enough values|too many values|IndexError"
        + "|NumberFormat|InputMismatch|NoSuchElement|ArrayIndexOutOfBounds|StringIndexOutOfBounds|ParseIntError"
        + "|invalid digit|invalid literal|FormatException|NaN|\\{\\s*\\\\?\"|JSON|Json|json");

    /** Source line of a traceback that takes a field of an object, as programs that read JSON do. */
    private static final Pattern OF_OBJECT = Pattern.compile("\\[(\"\\w+\"|'\\w+')]");

    /**
     * @param protocol the protocol in which the bot was asked
     * @param other    whether the scene has the other protocol too
     * @param answers  how many valid answers it had given
     * @param reason   as the referee says it
     * @param received what was received in place of an answer
     * @param stderr   the last lines it wrote there
     * @param time     where the time of a late answer went, or {@code null}
     * @param sandbox  how it was kept apart, or {@code null} if that is not known
     */
    static List<String> of(Protocol protocol, BooleanSupplier other, int answers, String reason, String received,
                           List<String> stderr, TimeSpent time, Isolation sandbox) {
        List<String> hints = new ArrayList<>();
        if (FaultMessages.isExit(reason, NOT_FOUND_STATUS)) {
            hints.add(NOT_FOUND);
        } else if (FaultMessages.isExit(reason, NOT_EXECUTABLE_STATUS)) {
            hints.add(NOT_EXECUTABLE);
        } else if (answers == 0) {
            if (FaultMessages.isLate(reason) && received.isEmpty() && (time == null || !time.starved())) {
                hints.add(FLUSH);
            }
            if (speaksTheOther(protocol, reason, received, stderr) && other.getAsBoolean()) {
                hints.add(protocol == Protocol.JSON ? CODINGAME : JSON);
            }
        }
        if (time != null && time.starved()) {
            hints.add(STARVED);
        }
        if (sandbox != null && FaultMessages.isExit(reason)) {
            if (sandbox.limits().memory() > 0) {
                hints.add(MEMORY);
            }
            if (answers == 0 && stderr.stream().anyMatch(line -> isOfSandbox(line, sandbox.level()))) {
                hints.add(sandbox.level() == SandboxLevel.STRICT ? STRICT : LIGHT);
            }
        }
        return hints;
    }

    /** True if a line is that of a JVM that finds no main class. */
    static boolean isClassMissing(String line) {
        return line.startsWith("Error: Could not find or load main class");
    }

    /** The hint for a path that the bot lacked, as it seems. */
    static String missing(Path path) {
        return "strict does not show it what it seems to need; try --visible "
            + TextFormat.plain(CommandLine.quote(List.of(path.toString())));
    }

    /** True if a line says that the network was missing, or a file that this machine has. */
    private static boolean isOfSandbox(String line, SandboxLevel level) {
        return level != SandboxLevel.OFF && (UNREACHABLE.matcher(line).find()
            || READ_ONLY.matcher(line).find() && PATH.matcher(line).find()
            || DENIED.matcher(line).find() && PATH.matcher(line).results().map(MatchResult::group).anyMatch(path ->
                level == SandboxLevel.STRICT ? Files.exists(Path.of(path)) : path.startsWith("/proc/")));
    }

    /** Bot that computed meanwhile. */
    static String beside(String name, Burner burner) {
        return String.format(Locale.ROOT, "meanwhile %s computed on %.2f processors%s; such a game is played again, "
            + "unless its replay has been shown by then", name, burner.processors(),
            burner.holdable() ? "" : " and cannot be held here");
    }

    /** True if it exited at its first input, or answered in the form of the other protocol. */
    private static boolean speaksTheOther(Protocol protocol, String reason, String received, List<String> stderr) {
        if (FaultMessages.isExit(reason)) {
            boolean readsObjects = stderr.stream().anyMatch(line -> OF_OBJECT.matcher(line).find());
            return !reason.equals(FaultMessages.exited(0))
                && stderr.stream().noneMatch(line -> CLEAR.matcher(line).find())
                && (protocol != Protocol.JSON || !readsObjects)
                && (readsObjects || stderr.stream().noneMatch(line -> TRACEBACK.matcher(line).find())
                || stderr.stream().anyMatch(line -> OF_INPUT.matcher(line).find()));
        }
        boolean object = received.stripLeading().startsWith("{");
        return !received.isBlank() && object == (protocol == Protocol.CODINGAME);
    }
}
