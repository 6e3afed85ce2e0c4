package steward.bots;

/**
 * Decides by simulation: for every own pod a few dozen first moves are simulated against the expected moves of the pods
 * around, and the best is taken. The own leading pod races; of the others every second one guards, that is, blocks the
 * leading enemy.
 */
final class LookAhead implements Strategy {

    private MoveSearch search;

    @Override
    public void decide(Race race, Pods pods, Commands commands) {
        if (search == null) {
            search = new MoveSearch(race);
        }
        int leader = leader(race, pods, true);
        int enemy = leader(race, pods, false);
        int others = 0;
        for (int pod = 0; pod < pods.size; pod++) {
            if (pods.player[pod] == race.player) {
                boolean guards = enemy >= 0 && pod != leader && others++ % 2 == 0;
                search.choose(pods, pod, guards ? enemy : MoveSearch.NO_ENEMY, commands);
            }
        }
    }

    /** The leading pod among the own or among all others; -1 when there is none. */
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

    /** Pods of players that are out come to rest; at the start all pods are at rest. */
    private static boolean moves(Pods pods, int pod) {
        return pods.vx[pod] != 0 || pods.vy[pod] != 0 || pods.headingX[pod] == 0 && pods.headingY[pod] == 0;
    }
}
