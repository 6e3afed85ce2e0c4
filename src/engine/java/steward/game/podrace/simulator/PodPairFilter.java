package steward.game.podrace.simulator;

import steward.physics.event.FarPairs;
import steward.physics.event.OfficialAdvance;

/** Filter of pairs of pods that cannot meet in a turn, by their places and velocities in {@link PodTurn}'s array. */
final class PodPairFilter {

    /** True if no pair of four pods can meet, by the coarse test without a loop; true for most turns. */
    static boolean allFar(double[] of, double reach) {
        double x0 = of[PodTurn.X];
        double y0 = of[PodTurn.Y];
        double vx0 = of[PodTurn.VX];
        double vy0 = of[PodTurn.VY];
        double x1 = of[PodTurn.SPEED + PodTurn.X];
        double y1 = of[PodTurn.SPEED + PodTurn.Y];
        double vx1 = of[PodTurn.SPEED + PodTurn.VX];
        double vy1 = of[PodTurn.SPEED + PodTurn.VY];
        double x2 = of[2 * PodTurn.SPEED + PodTurn.X];
        double y2 = of[2 * PodTurn.SPEED + PodTurn.Y];
        double vx2 = of[2 * PodTurn.SPEED + PodTurn.VX];
        double vy2 = of[2 * PodTurn.SPEED + PodTurn.VY];
        double x3 = of[3 * PodTurn.SPEED + PodTurn.X];
        double y3 = of[3 * PodTurn.SPEED + PodTurn.Y];
        double vx3 = of[3 * PodTurn.SPEED + PodTurn.VX];
        double vy3 = of[3 * PodTurn.SPEED + PodTurn.VY];
        return FarPairs.areFar(x0 - x1, y0 - y1, vx0 - vx1, vy0 - vy1, reach)
            && FarPairs.areFar(x0 - x2, y0 - y2, vx0 - vx2, vy0 - vy2, reach)
            && FarPairs.areFar(x0 - x3, y0 - y3, vx0 - vx3, vy0 - vy3, reach)
            && FarPairs.areFar(x1 - x2, y1 - y2, vx1 - vx2, vy1 - vy2, reach)
            && FarPairs.areFar(x1 - x3, y1 - y3, vx1 - vx3, vy1 - vy3, reach)
            && FarPairs.areFar(x2 - x3, y2 - y3, vx2 - vx3, vy2 - vy3, reach);
    }

    /** The pairs that may meet, as bits in the order of the scan. */
    static long nearPairs(double[] from, int pods, OfficialAdvance advance) {
        long near = 0;
        long bit = 1;
        for (int i = PodTurn.SPEED * (pods - 1); i > 0; i -= PodTurn.SPEED) {
            double xi = from[i + PodTurn.X];
            double yi = from[i + PodTurn.Y];
            double vxi = from[i + PodTurn.VX];
            double vyi = from[i + PodTurn.VY];
            for (int j = i - PodTurn.SPEED; j >= 0; j -= PodTurn.SPEED) {
                if (advance.mayMeet(xi - from[j + PodTurn.X], yi - from[j + PodTurn.Y], vxi - from[j + PodTurn.VX],
                    vyi - from[j + PodTurn.VY])) {
                    near |= bit;
                }
                bit <<= 1;
            }
        }
        return near;
    }
}
