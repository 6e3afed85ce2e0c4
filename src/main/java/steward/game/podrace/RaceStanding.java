package steward.game.podrace;

/**
 * The standing of a pod race. A player is ahead by having finished, else by a later elimination, else by more
 * checkpoints passed by the best pod, else by being nearer to the next.
 */
final class RaceStanding {

    private final PodRace race;

    RaceStanding(PodRace race) {
        this.race = race;
    }

    /** For each player, the number of players ahead. */
    int[] ranks() {
        int[] ranks = new int[race.players()];
        for (int player = 0; player < ranks.length; player++) {
            for (int other = 0; other < ranks.length; other++) {
                ranks[player] += isAhead(other, player) ? 1 : 0;
            }
        }
        return ranks;
    }

    private boolean isAhead(int one, int other) {
        if (hasFinished(one) || hasFinished(other)) {
            return hasFinished(one) && !hasFinished(other);
        }
        if (!race.isIn(one) || !race.isIn(other)) {
            return race.outTurn(one) > race.outTurn(other);
        }
        return isBetter(bestPod(one), bestPod(other));
    }

    /** For each player, the checkpoints passed by the best pod; -1 after an elimination. */
    double[] scores() {
        double[] scores = new double[race.players()];
        for (int player = 0; player < scores.length; player++) {
            scores[player] = race.isIn(player) ? race.passed(bestPod(player)) : -1;
        }
        return scores;
    }

    boolean hasFinished(int player) {
        return race.isIn(player) && race.passed(bestPod(player)) >= race.toFinish();
    }

    /** The pod that has passed more checkpoints, then the one nearer to the next. */
    int bestPod(int player) {
        int perPlayer = race.settings().podsPerPlayer();
        int best = player * perPlayer;
        for (int pod = best + 1; pod < (player + 1) * perPlayer; pod++) {
            if (isBetter(pod, best)) {
                best = pod;
            }
        }
        return best;
    }

    private boolean isBetter(int pod, int other) {
        return race.passed(pod) != race.passed(other) ? race.passed(pod) > race.passed(other)
            : race.toNext(pod) < race.toNext(other);
    }
}
