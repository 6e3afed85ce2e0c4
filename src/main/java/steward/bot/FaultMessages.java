package steward.bot;

import java.util.regex.Pattern;

/** Messages that say how a player failed. */
public final class FaultMessages {

    /** Statuses above this are 128 + the number of the signal that ended the process. */
    private static final int SIGNALLED = 128;

    /** Fault of a bot whose sandbox does not do what it is told. */
    public static final String LOST = "kept the first process of its sandbox from answering";

    /** Linux's names for the signals 1 to 31, by their numbers on x86 and ARM. */
    private static final String[] SIGNALS = {
        "HUP", "INT", "QUIT", "ILL", "TRAP", "ABRT", "BUS", "FPE", "KILL", "USR1", "SEGV", "USR2", "PIPE", "ALRM",
        "TERM", "STKFLT", "CHLD", "CONT", "STOP", "TSTP", "TTIN", "TTOU", "URG", "XCPU", "XFSZ", "VTALRM", "PROF",
        "WINCH", "IO", "PWR", "SYS"};

    private static final int LAST_SIGNAL = 64;

    private static final String LATE = "no answer within ";
    private static final String UNREAD = "did not read its input within ";

    /**
     * Measured part in brackets behind a limit, and the parts of {@link TimeSpent#text}. There are no brackets within:
     * so the time that it takes grows with the length of a text, which may be a stranger's, and not with its square.
     */
    private static final Pattern MEASURED =
        Pattern.compile(" \\((waited|used) [^()]*\\)|[:;] (computed (\\d|all |for )|the machine was busy"
            + "|this system does not show ).*");

    private FaultMessages() { }

    /** {@code no answer within 75 ms (waited 76 ms)}. */
    public static String late(long limitNanos, long waitedNanos) {
        return LATE + within(TimeBasis.WALL, limitNanos, waitedNanos);
    }

    private static String within(TimeBasis basis, long limitNanos, long waitedNanos) {
        String backstop = switch (basis) {
            case WALL -> "";
            case CPU -> ", " + TimeBasis.BACKSTOP + " times the limit of CPU time";
            case UNSTARVED -> ", without waiting for a processor";
        };
        return limit(limitNanos) + backstop + " (waited " + waited(waitedNanos) + ")";
    }

    /** Returns {@link #late} with what had been received: {@code : 1 of 2 lines came}. */
    static String withLines(String fault, int lines, int expected, int partialBytes) {
        if (lines >= expected) {
            return fault;
        }
        if (expected > 1 && (lines > 0 || partialBytes > 0)) {
            return fault + ": " + lines + " of " + expected + " lines came";
        }
        return partialBytes == 0 ? fault : fault + ": " + partialBytes + " bytes came, without a line end";
    }

    /**
     * A missed deadline with where the time went: {@code no answer within 75 ms (waited 76 ms): computed 2, waited 53
     * for a processor, 2 other, 19 before the first look}.
     *
     * @param basis  what the limit of a turn is a limit of
     * @param unread whether the bot did not read its input
     */
    public static String missed(TimeSpent spent, TimeBasis basis, boolean unread, int lines, int expected,
                                int partialBytes) {
        TimeBasis of = basis == TimeBasis.UNSTARVED && spent.doubtful() ? TimeBasis.WALL : basis;
        String fault = spent.overCpu() ? overCpu(spent.limit(), spent.cpu(), spent.taken())
            : unread ? UNREAD + within(of, spent.limit(), spent.taken())
            : withLines(LATE + within(of, spent.limit(), spent.taken()), lines, expected, partialBytes);
        return fault + (fault.endsWith(")") ? ": " : "; ") + spent.text();
    }

    /**
     * {@code no answer within 75 ms of CPU time (used 81 ms in 130 ms)}.
     *
     * @param usedNanos  by all threads together
     * @param takenNanos by the wall clock
     */
    static String overCpu(long limitNanos, long usedNanos, long takenNanos) {
        return LATE + limit(limitNanos) + " of CPU time (used " + waited(usedNanos) + " in " + waited(takenNanos) + ")";
    }

    /** Returns this fault without measured parts, which differ from one occurrence to the next; others stay. */
    public static String withoutTimes(String fault) {
        return MEASURED.matcher(fault).replaceAll("");
    }

    /** {@code used 612 MiB of memory, expected at most 512 MiB}. */
    public static String memory(long found, long limit) {
        return "used " + (found + (1 << 20) - 1 >> 20) + " MiB of memory, expected at most " + (limit >> 20) + " MiB";
    }

    /** {@code line longer than 65536 bytes}. */
    public static String tooLong(int limit) {
        return "line longer than " + limit + " bytes";
    }

    /** {@code exited with status 3 before answering}, or {@code killed by signal 11 (SIGSEGV) before answering}. */
    public static String exited(int status) {
        int signal = status - SIGNALLED;
        if (signal > 0 && signal <= LAST_SIGNAL) {
            String name = signal <= SIGNALS.length ? " (SIG" + SIGNALS[signal - 1] + ")" : "";
            return "killed by signal " + signal + name + " before answering";
        }
        String meaning = switch (status) {
            case 126 -> " (126: a command cannot be executed)";
            case 127 -> " (127: a command was not found)";
            default -> "";
        };
        return "exited with status " + status + " before answering" + meaning;
    }

    /** True if a fault is one of {@link #late} or {@link #overCpu}. */
    public static boolean isLate(String fault) {
        return fault.startsWith(LATE);
    }

    /** True if a fault is one of time: {@link #late}, {@link #overCpu} or input that was not read in time. */
    public static boolean isTime(String fault) {
        return isLate(fault) || fault.startsWith(UNREAD);
    }

    /** True if a fault is one of {@link #exited}, by itself or by a signal. */
    public static boolean isExit(String fault) {
        return fault.startsWith("exited with status ") || fault.startsWith("killed by signal ");
    }

    /** True if a fault is that of {@link #exited} with just this status. */
    public static boolean isExit(String fault, int status) {
        return fault.equals(exited(status));
    }

    /** Milliseconds as they were asked for: whole, or with up to three decimals. */
    static String limit(long nanos) {
        long micros = nanos / 1000;
        String fraction = String.valueOf(1000 + micros % 1000).substring(1).replaceAll("0+$", "");
        return micros / 1000 + (fraction.isEmpty() ? "" : "." + fraction) + " ms";
    }

    /** Milliseconds rounded up, so that a wait beyond a limit never prints as the limit; one decimal below 10. */
    static String waited(long nanos) {
        long tenths = Math.floorDiv(nanos + 99_999, 100_000L);
        if (tenths < 100) {
            return tenths / 10 + "." + tenths % 10 + " ms";
        }
        return Math.floorDiv(nanos + 999_999, 1_000_000L) + " ms";
    }
}
