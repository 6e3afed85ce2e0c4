package steward.bots;

/**
 * Decides by trying: for every own pod a few dozen first moves are played forward against what the pods around are
 * expected to do, and the best is taken. The own leader races; of the others every second one guards, that is, stands
 * in the way of the leading enemy.
 */
final class LookAhead implements Strategy {

    private Search search;

    @Override
    public void decide(Race race, Pods pods, Commands commands) {
        if (search == null) {
            search = new Search(race);
        }
        int leader = leader(race, pods, true);
        int enemy = leader(race, pods, false);
        int others = 0;
        for (int pod = 0; pod < pods.size; pod++) {
            if (pods.player[pod] == race.player) {
                boolean guards = enemy >= 0 && pod != leader && others++ % 2 == 0;
                search.choose(pods, pod, guards ? enemy : Search.NOBODY, commands);
            }
        }
    }

    /** The pod in front among the own or among all others; -1 when there is none. */
    private static int leader(Race race, Pods pods, boolean own) {
        int leader = -1;
        for (int pod = 0; pod < pods.size; pod++) {
            boolean counts = pods.player[pod] == race.player == own && (own || moves(pods, pod));
            if (counts && (leader < 0 || pods.isAhead(race, pod, leader))) {
                leader = pod;
            }
        }
        return leader;
    }

    /** Pods of players who are out come to rest; at the start everybody is. */
    private static boolean moves(Pods pods, int pod) {
        return pods.vx[pod] != 0 || pods.vy[pod] != 0 || pods.headingX[pod] == 0 && pods.headingY[pod] == 0;
    }
}
