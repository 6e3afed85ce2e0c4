package steward.cli.shared;

import java.util.Locale;
import steward.cli.streams.Streams;

/** Report of a JVM that ran out of memory: one line with advice, from whichever thread. */
public final class OutOfMemory {

    private static final double MEGABYTE = 1 << 20;
    /** Causes can be nested without end. */
    private static final int DEEPEST = 20;

    private OutOfMemory() { }

    /** True if a lack of memory is the problem or one of its causes. */
    public static boolean isBehind(Throwable problem) {
        Throwable cause = problem;
        for (int depth = 0; cause != null && depth < DEEPEST; depth++) {
            if (cause instanceof OutOfMemoryError) {
                return true;
            }
            cause = cause.getCause();
        }
        return false;
    }

    /** @return the exit status */
    public static int report(Streams streams) {
        streams.err().println(String.format(Locale.ROOT, "steward: out of memory: Java may use %.0f MB here; "
            + "JAVA_OPTS=-Xmx4g gives it 4 GB", Runtime.getRuntime().maxMemory() / MEGABYTE));
        return ExitStatus.FAILED;
    }

    /** For threads that no other waits for: ends the program in order, so that what was recorded is written. */
    public static void endProgram(Streams streams) {
        Thread.UncaughtExceptionHandler usual = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, problem) -> {
            if (isBehind(problem)) {
                System.exit(report(streams));
            } else if (usual != null) {
                usual.uncaughtException(thread, problem);
            } else {
                streams.err().println("steward: this should not have happened, in thread " + thread.getName() + ":");
                problem.printStackTrace(streams.err());
            }
        });
    }
}
