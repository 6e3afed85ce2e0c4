package steward.lab.bench;

/** Amount of measuring. */
public enum Effort {
    /** Minutes in all: for ratios that differ much. */
    QUICK(50, 1500, 5, 20),
    /** Minutes. */
    NORMAL(3000, 9000, 7, 200),
    /** For tables that are kept. */
    LONG(4000, 12000, 11, 500);

    private final long warmUpMs;
    private final long mostWarmUpMs;
    private final int rounds;
    private final long roundMs;

    Effort(long warmUpMs, long mostWarmUpMs, int rounds, long roundMs) {
        this.warmUpMs = warmUpMs;
        this.mostWarmUpMs = mostWarmUpMs;
        this.rounds = rounds;
        this.roundMs = roundMs;
    }

    /** Returns how long each contender warms up at least, in milliseconds of CPU time. */
    public long warmUpMs() {
        return warmUpMs;
    }

    /** Returns how long a contender warms up that does not settle, in milliseconds of CPU time. */
    long mostWarmUpMs() {
        return mostWarmUpMs;
    }

    /** Returns how many measurements the median is taken of. */
    public int rounds() {
        return rounds;
    }

    /** Returns how many measurements the median is taken of where each takes many seconds. */
    public int fewRounds() {
        return this == QUICK ? 1 : this == NORMAL ? 3 : 5;
    }

    /** Returns the CPU time of one measurement, in milliseconds. */
    long roundMs() {
        return roundMs;
    }
}
