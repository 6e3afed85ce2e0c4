package steward.lab.tradeoff;

/**
 * How much work a measurement of the trade-off does.
 *
 * @param share    of a scene's states and free runs
 * @param rounds   of timing, over which medians are taken; at least 3
 * @param budget   seconds of CPU for the rounds of a scene: beyond it no further round begins, except the first three
 * @param warmUp   seconds of CPU that each rung runs before it is timed
 * @param round    seconds of CPU that each rung runs in a round, at least; all states once in any case
 * @param podTurns turns of headings, for each of the two ways
 */
public record TradeoffEffort(double share, int rounds, double budget, double warmUp, double round, int podTurns) {

    /** Takes some minutes. */
    public static final TradeoffEffort NORMAL = new TradeoffEffort(1, 15, 8, 0.2, 0.015, 10_000_000);
    /** Takes some seconds a scene. */
    public static final TradeoffEffort QUICK = new TradeoffEffort(0.05, 3, 1, 0.06, 0.002, 200_000);

    /** A scene's count at this effort, but not below the given least. */
    int of(int count, int least) {
        return Math.max(Math.min(count, least), (int) Math.round(share * count));
    }
}
