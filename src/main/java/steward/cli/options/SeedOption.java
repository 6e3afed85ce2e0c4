package steward.cli.options;

import java.util.SplittableRandom;
import picocli.CommandLine.Option;

/** Option for the seed of a match's random draws. */
public final class SeedOption {

    /** Seeds that are drawn stay below this: people can type them again, and some tools keep 31 bits. */
    private static final long DRAWN_SEEDS = 1_000_000_000;

    @Option(names = "--seed", paramLabel = "N", description = "The seed of the game's random numbers (default: a "
        + "random seed).")
    private Long seed;

    /** True if a seed was given. */
    public boolean isGiven() {
        return seed != null;
    }

    /** The given seed, or a drawn one. */
    public long orDrawn() {
        return seed == null ? draw() : seed;
    }

    /** A drawn seed, for a game that may be any. */
    public static long draw() {
        return new SplittableRandom().nextLong(DRAWN_SEEDS);
    }

    /** The seed, or another if none was given. */
    public long or(long other) {
        return seed == null ? other : seed;
    }
}
