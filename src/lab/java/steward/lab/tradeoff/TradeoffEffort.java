package steward.lab.tradeoff;

import steward.lab.timing.TimingEffort;

/**
 * Amount of work of a trade-off measurement.
 *
 * @param share    of a scene's states and free runs
 * @param timing   of the rungs
 * @param podTurns turns of headings, for each of the two ways
 */
public record TradeoffEffort(double share, TimingEffort timing, int podTurns) {

    /** Takes some minutes. */
    public static final TradeoffEffort NORMAL = new TradeoffEffort(1, TimingEffort.NORMAL, 10_000_000);
    /** Takes some seconds a scene; its figures may not be quoted. */
    public static final TradeoffEffort QUICK = new TradeoffEffort(0.05, TimingEffort.QUICK, 200_000);

    /** A scene's count at this effort, but not below the given least. */
    int of(int count, int least) {
        return Math.max(Math.min(count, least), (int) Math.round(share * count));
    }
}
