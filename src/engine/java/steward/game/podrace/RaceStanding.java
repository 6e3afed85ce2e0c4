package steward.game.podrace;

/**
 * Ranking of a pod race's players: players who are in come first, then more checkpoints passed, then the distance to
 * the next one. For both a player's best pod counts, and checkpoints are counted on behind the finish. All players who
 * are out share the last rank.
 */
record RaceStanding(PodRace race) {

    /** Per player the checkpoints passed by the best pod, -1 for one who is out. */
    double[] scores() {
        double[] scores = new double[race.players()];
        for (int player = 0; player < scores.length; player++) {
            scores[player] = race.isIn(player) ? race.passed(bestPod(player)) : -1;
        }
        return scores;
    }

    boolean hasFinished(int player) {
        if (!race.isIn(player)) {
            return false;
        }
        int perPlayer = race.settings().podsPerPlayer();
        int most = 0;
        for (int pod = player * perPlayer; pod < (player + 1) * perPlayer; pod++) {
            most = Math.max(most, race.passed(pod));
        }
        return most >= race.toFinish();
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

    boolean isBetter(int pod, int other) {
        return race.passed(pod) != race.passed(other) ? race.passed(pod) > race.passed(other)
            : race.toNext(pod) < race.toNext(other);
    }
}
