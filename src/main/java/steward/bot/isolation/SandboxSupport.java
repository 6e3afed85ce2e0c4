package steward.bot.isolation;

import java.util.List;
import steward.bot.command.Program;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;
import steward.text.TextFormat;

/** Levels of isolation that work on this machine. Each level is tried once per JVM, when it is asked for. */
public final class SandboxSupport {

    /** How long a trial may take, in milliseconds. */
    private static final long PATIENCE_MS = 10_000;

    private static final int SHOWN = 100;

    /**
     * With what the bot of a trial exits: a launcher that was cut to nothing ends with status 0, and starts none. It is
     * no word on the output, which a full disk would swallow.
     */
    private static final int INSIDE = 42;

    private SandboxSupport() { }

    private static final class Light {
        static final String PROBLEM = tried(SandboxLevel.LIGHT);
    }

    private static final class Strict {
        static final String PROBLEM = tried(SandboxLevel.STRICT);
    }

    /** Returns why a level does not work here, or {@code null} if it does. */
    public static String problem(SandboxLevel level) {
        return switch (level) {
            case OFF -> null;
            case LIGHT -> Light.PROBLEM;
            case STRICT -> Strict.PROBLEM;
        };
    }

    /** {@link SandboxLevel#LIGHT} where it works, otherwise {@link SandboxLevel#OFF}. */
    public static SandboxLevel usual() {
        return problem(SandboxLevel.LIGHT) == null ? SandboxLevel.LIGHT : SandboxLevel.OFF;
    }

    /** True if bots are started by the small program that starts faster than a shell and others. */
    public static boolean isNative() {
        return NativeLauncher.program() != null;
    }

    /** Reason why {@link #isNative} is false. */
    public static final String NO_LAUNCHER =
        "there is no C compiler, or its program cannot be kept in the user's cache";

    /** True if the small program keeps bots in a sandbox from system calls that no bot needs. */
    public static boolean isFiltered() {
        return NativeLauncher.filters();
    }

    /** True if this program runs as root, whose files are a bot's own at level light. */
    public static boolean isRoot() {
        return UserNumbers.isRoot();
    }

    private static String tried(SandboxLevel level) {
        try {
            return problemOf(level);
        } catch (Error problem) {
            // The JDK's class for processes refuses to load where jdk.lang.Process.launchMechanism is not a known one,
            // at the first use by a plain Error, later by a NoClassDefFoundError.
            return "this JVM cannot start programs";
        }
    }

    private static String problemOf(SandboxLevel level) {
        List<String> programs = level == SandboxLevel.STRICT ? List.of("setsid", "bwrap", "sh")
            : isNative() ? List.of("setsid", "sh") : List.of("setsid", "sh", "unshare", "setpriv", "env");
        for (String program : programs) {
            if (ProgramFinder.find(program) == null) {
                return "there is no program '" + program + "'";
            }
        }
        // A bot that is one of the first processes of its namespace, and finds itself there.
        List<String> bot = List.of(ProgramFinder.find("sh").toString(), "-c",
            "[ $$ -lt 10 ] && [ -d /proc/$$ ] && exit " + INSIDE);
        try {
            ProgramTrial tried = ProgramTrial.of(Launch.words(Isolation.at(level), Program.here(bot), List.of(), null,
                null), PATIENCE_MS);
            return tried.status() == INSIDE ? null
                : FailedTrial.here().reason(TextFormat.shorten(TextFormat.plain(tried.line()), SHOWN),
                tried.status());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return "interrupted while it was tried";
        }
    }
}
