package steward.game.podrace.simulator;

/** Tests whether the certified speeds of pods in {@link PodTurn}'s array decide every rounding at a turn's end. */
final class CertainRounding {

    /*
     * In a turn with impacts the game moves all pods from impact to impact, also those without impacts; a position is
     * rounded at each, by less than 2^-37. In MOST_CORNERS / 2 flights that stays below the 2^-27 that PodTurn.DOUBT
     * leaves.
     */

    /** The most corners of all paths in a turn. */
    static final int MOST_CORNERS = 500;

    /** True if the roundings of these pods (bits) are all certain: no fraction is close to where the result changes. */
    static boolean areSure(int which, double[] speed, int pods) {
        for (int pod = 0; pod < pods; pod++) {
            if ((which >> pod & 1) != 0 && !isSure(speed, PodTurn.SPEED * pod)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isSure(double[] speed, int in) {
        double x = speed[in + PodTurn.X];
        double y = speed[in + PodTurn.Y];
        double lostX = Math.abs(speed[in + PodTurn.VX] * PodTurn.KEEP);
        double lostY = Math.abs(speed[in + PodTurn.VY] * PodTurn.KEEP);
        return farFromWhole(x + speed[in + PodTurn.VX] + 0.5) && farFromWhole(y + speed[in + PodTurn.VY] + 0.5)
            && farFromWhole(lostX) && farFromWhole(lostY) && Math.max(lostX, lostY) < PodTurn.SMALL
            && Math.max(Math.abs(x), Math.abs(y)) < PodTurn.SMALL;
    }

    private static boolean farFromWhole(double value) {
        return Math.abs(value - Math.rint(value)) > PodTurn.DOUBT;
    }
}
