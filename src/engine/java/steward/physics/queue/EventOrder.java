package steward.physics.queue;

import steward.physics.event.ImpactQueue;

/**
 * Breaks ties between events whose times are equal as doubles: first by the low parts; then cell crossings come first,
 * and of impacts the lowest pair, bodies before walls.
 */
record EventOrder(Crowd crowd) implements EventBuckets.Order {

    @Override
    public boolean isBefore(int i, int j) {
        double lowI = low(i);
        double lowJ = low(j);
        if (lowI != lowJ) {
            return lowI < lowJ;
        }
        long rankI = rank(i);
        long rankJ = rank(j);
        return rankI < rankJ || rankI == rankJ && crowd.index[i] < crowd.index[j];
    }

    /** The low part of the time of an impact; 0 for a cell crossing. */
    private double low(int body) {
        return crowd.low.length == 0 || crowd.link[8 * body + Crowd.EVENT] != 0
            ? 0 : crowd.low[4 * body + Crowd.IMPACT_LOW];
    }

    private long rank(int body) {
        return crowd.link[8 * body + Crowd.EVENT] != 0 ? -1 : rank(crowd, body, crowd.link[8 * body + Crowd.PARTNER]);
    }

    static long rank(Crowd crowd, int body, int partner) {
        return ImpactQueue.OneAtATime.rank(crowd.index[body], partner < 0 ? partner : crowd.index[partner]);
    }
}
