package steward.physics;

/** Breaks ties between events at the same time: crossings come first, then the lowest pair, bodies before walls. */
final class EventOrder implements EventBuckets.Order {

    private final Crowd crowd;

    EventOrder(Crowd crowd) {
        this.crowd = crowd;
    }

    @Override
    public boolean isBefore(int i, int j) {
        long rankI = rank(i);
        long rankJ = rank(j);
        return rankI < rankJ || rankI == rankJ && crowd.index[i] < crowd.index[j];
    }

    private long rank(int body) {
        return crowd.link[8 * body + Crowd.EVENT] != 0 ? -1 : rank(crowd, body, crowd.link[8 * body + Crowd.PARTNER]);
    }

    static long rank(Crowd crowd, int body, int partner) {
        return ImpactQueue.OneAtATime.rank(crowd.index[body], partner < 0 ? partner : crowd.index[partner]);
    }
}
