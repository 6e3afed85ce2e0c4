package steward.game.pokerchiprace;

/**
 * Scores of the players as the published referee computes them. In the order of their areas each player gets one more
 * than the player before; players who are left also get their area. Without chips, a player who lost them later is
 * better.
 */
final class Ranking {

    private static final double STILL_IN = -1;

    private final int[] order;
    private final int[] scores;
    private final double[] areas;

    Ranking(int players) {
        order = new int[players];
        scores = new int[players];
        areas = new double[players];
    }

    /** Takes the scores of another. */
    void copy(Ranking other) {
        System.arraycopy(other.scores, 0, scores, 0, scores.length);
    }

    int score(int player) {
        return scores[player];
    }

    /** @param lost per player the turn and time at which it lost its last chip, below 0 while it has one */
    void set(ChipTable table, double[] lost) {
        for (int k = 0; k < order.length; k++) {
            areas[k] = table.areaOf(k);
            int at = k;
            while (at > 0 && compare(table, lost, order[at - 1], k) > 0) {
                order[at] = order[at - 1];
                at--;
            }
            order[at] = k;
        }
        int score = -1;
        double lastArea = -1;
        double lastLost = -1;
        for (int player : order) {
            if (lost[player] > STILL_IN) {
                if (lost[player] > lastLost) {
                    lastLost = lost[player];
                    score++;
                }
                scores[player] = score;
            } else {
                if (areas[player] > lastArea) {
                    lastArea = areas[player];
                    score++;
                }
                scores[player] = (int) (areas[player] + 0.5) + score;
            }
        }
    }

    private double compare(ChipTable table, double[] lost, int one, int other) {
        double difference = areas[one] - areas[other];
        return difference != 0 || table.owned(one) > 0 || table.owned(other) > 0 ? difference
            : lost[one] - lost[other];
    }
}
