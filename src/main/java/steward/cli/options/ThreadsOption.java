package steward.cli.options;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import picocli.CommandLine.Option;
import steward.cli.streams.Streams;

/** Option for the number of games that are played at the same time. */
public final class ThreadsOption {

    private static final String AUTO = "auto";
    /** A tenth of two processors is what a system does by itself. */
    private static final double IDLE = 0.1;

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--threads", paramLabel = "T|auto",
        description = "Plays T games at the same time (default: 1). auto: one less than there are processors, or "
            + "both of two if nothing else runs. Games do not depend on it, but bots that share processors take "
            + "longer to answer.")
    private String threads;
    /** As it was first counted, since bots of this run are load, too; -1 before. */
    private int counted = -1;

    /** Refuses what is no number of threads. */
    public void check() {
        check(1);
    }

    /** Refuses what is no number of threads. @param least that there may be */
    public void check(int least) {
        check.that(threads == null || threads(1) >= least,
            "--threads: found '" + threads + "', expected " + least + " to " + CallCheck.MOST_THREADS + ", or auto");
    }

    /** True if it is there. */
    public boolean isGiven() {
        return threads != null;
    }

    /** Returns how many games at the same time; warns if there are too few processors for them. */
    public int count(Streams streams) {
        int processors = Runtime.getRuntime().availableProcessors();
        counted = counted < 0 ? threads(processors) : counted;
        int count = counted;
        if (count > processors) {
            streams.warn("--threads " + count + " are more games at a time than the " + processors
                + " processors here carry: bots will take longer to answer, perhaps too long; --threads auto takes "
                + auto(processors));
        }
        return count;
    }

    /** -1 if it cannot be understood. */
    private int threads(int processors) {
        if (threads == null) {
            return 1;
        }
        if (threads.equals(AUTO)) {
            return auto(processors);
        }
        try {
            int count = Integer.parseInt(threads);
            return CallCheck.isWithin(count, 0, CallCheck.MOST_THREADS) ? count : -1;
        } catch (NumberFormatException problem) {
            return -1;
        }
    }

    private static int auto(int processors) {
        return auto(processors, processors == 2 && Load.ofOthers() < IDLE);
    }

    /**
     * A game keeps one processor busy, since bots are asked in turns; one is left for everything else, but not where
     * that would be half of them and nothing else runs.
     */
    static int auto(int processors, boolean idle) {
        return Math.max(1, Math.min(processors == 2 && idle ? 2 : processors - 1, CallCheck.MOST_THREADS));
    }

    /** Load of the processors by other programs. */
    private static final class Load {

        private static final long SAMPLE_MS = 200;

        /** The share of all processors, 0..1; 1 if the system does not tell. */
        static double ofOthers() {
            if (!(ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system)) {
                return 1;
            }
            system.getCpuLoad();                       // the next call is about the time since this one
            system.getProcessCpuLoad();
            try {
                Thread.sleep(SAMPLE_MS);
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
                return 1;
            }
            double all = system.getCpuLoad();
            return all < 0 ? 1 : all - Math.max(0, system.getProcessCpuLoad());
        }
    }
}
