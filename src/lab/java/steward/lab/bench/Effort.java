package steward.lab.bench;

/** Amount of measuring. */
public enum Effort {
    /** Seconds: to see that it works. */
    QUICK(50, 3, 20),
    /** Minutes. */
    NORMAL(3000, 7, 200),
    /** For tables that are kept. */
    LONG(4000, 11, 500);

    private final long warmUpMs;
    private final int rounds;
    private final long roundMs;

    Effort(long warmUpMs, int rounds, long roundMs) {
        this.warmUpMs = warmUpMs;
        this.rounds = rounds;
        this.roundMs = roundMs;
    }

    /** Returns how long each contender warms up, in milliseconds of CPU time. */
    public long warmUpMs() {
        return warmUpMs;
    }

    /** Returns how many measurements the median is taken of. */
    public int rounds() {
        return rounds;
    }

    /** Returns the CPU time of one measurement, in milliseconds. */
    long roundMs() {
        return roundMs;
    }
}
