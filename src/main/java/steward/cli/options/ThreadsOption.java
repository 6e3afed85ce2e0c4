package steward.cli.options;

import java.util.Iterator;
import java.util.List;
import picocli.CommandLine.Option;
import steward.cli.shared.Streams;

/** The option that says how many games are played at the same time. */
public final class ThreadsOption {

    /** The word that {@code --threads} takes beside numbers. */
    static final class Auto implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return List.of(AUTO).iterator();
        }
    }

    private static final String AUTO = "auto";

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--threads", paramLabel = "T|auto", completionCandidates = Auto.class,
        description = "Plays so many games at the same time (default: 1); auto: as many as there are processors, less "
            + "one. The games do not depend on it, but bots that share processors take longer to answer.")
    private String threads;

    /** Refuses what is no number of threads. */
    public void check() {
        check.that(threads == null || threads(1) > 0,
            "--threads: found '" + threads + "', expected 1 to " + CallCheck.MOST_THREADS + ", or auto");
    }

    /** Whether it is there. */
    public boolean isGiven() {
        return threads != null;
    }

    /** How many games at the same time; warns if there are too few processors for them. */
    public int count(Streams streams) {
        int processors = Runtime.getRuntime().availableProcessors();
        int count = threads(processors);
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
            return CallCheck.isWithin(count, 1, CallCheck.MOST_THREADS) ? count : -1;
        } catch (NumberFormatException problem) {
            return -1;
        }
    }

    /** A game keeps one processor busy, since bots are asked in turns; one is left for everything else. */
    static int auto(int processors) {
        return Math.max(1, Math.min(processors - 1, CallCheck.MOST_THREADS));
    }
}
