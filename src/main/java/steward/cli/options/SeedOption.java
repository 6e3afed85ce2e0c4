package steward.cli.options;

import java.util.SplittableRandom;
import picocli.CommandLine.Option;

/** The option that says what a match draws by lot. */
public final class SeedOption {

    /** Seeds that are drawn stay below this: people can type them again, and some tools keep 31 bits. */
    private static final long DRAWN_SEEDS = 1_000_000_000;

    @Option(names = "--seed", paramLabel = "N", description = "What is drawn by lot follows from it (default: drawn).")
    private Long seed;

    /** The seed that was called for, or any. */
    public long orDrawn() {
        return seed == null ? draw() : seed;
    }

    /** For a game that may be any. */
    public static long draw() {
        return new SplittableRandom().nextLong(DRAWN_SEEDS);
    }
}
