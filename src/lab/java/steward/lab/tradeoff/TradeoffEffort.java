package steward.lab.tradeoff;

import steward.lab.timing.TimingEffort;

/**
 * Effort of a trade-off measurement: numbers of states, turns and rounds.
 *
 * @param share    of a scene's states and free runs
 * @param timing   of the rungs
 */
public record TradeoffEffort(double share, TimingEffort timing) {

    /** JVMs that time each rung: enough to see in which states its compiler settles. */
    public static final int JVMS = 7;

    private static final int ROUNDS = 5;

    /** Takes some seconds a scene; its figures may not be quoted. */
    public static final TradeoffEffort QUICK = new TradeoffEffort(0.05, TimingEffort.QUICK);

    /** @param jvms how many time each rung */
    public static TradeoffEffort normal(int jvms) {
        TimingEffort usual = TimingEffort.NORMAL;
        return new TradeoffEffort(1, new TimingEffort(jvms, ROUNDS, usual.round(), usual.warmLeast(),
            usual.warmMost()));
    }

    /** A scene's count at this effort, but not below the given least. */
    int of(int count, int least) {
        return Math.max(Math.min(count, least), (int) Math.round(share * count));
    }
}
