package steward.game.podrace.simulator;

import steward.physics.ImpactLaw;
import steward.physics.event.FarPairs;
import steward.physics.event.ScanPairs;

/**
 * Certified play of a turn's impacts from velocities that are accurate only to 2^-27, with a bound on all errors that
 * follow. Either every decision (which pairs meet, in which order, the result of each rounding, which checkpoints are
 * passed) is certified to be the game's, or this class gives up and the turn is played from the game's own directions.
 * It also gives up if proofs would be long: impacts within the same time window, grazing impacts, overlaps later than
 * at the start, high speeds, many impacts. Allocates nothing.
 */
final class CertifiedImpacts {

    private static final double TOUCH = 2 * PodTurn.RADIUS;
    private static final double TOUCH_SQUARE = TOUCH * TOUCH;
    /** 120; the proofs below depend on it, and on the push-out. */
    private static final double MINIMUM_IMPULSE = ImpactLaw.OFFICIAL_POD_RACE.minimumImpulse();
    /** The rules move each of an overlapping pair by half of the overlap plus this, in u: 1e-5. */
    private static final double PUSH_OUT = ImpactLaw.OFFICIAL_POD_RACE.pushOut();

    /*
     * Below, "ours" is what is computed here, "the game's" what the official expressions give. Two numbers bound the
     * differences, in u and u per turn, as lengths of vectors, for all pods:
     *   v, between two velocities, at first 2^-26;
     *   x, between two positions at the same time, at times when both have had the same impacts, at first 2^-30 (for
     *      the rounding of flights; the positions at the start of the turn are the same).
     * Guards: coordinates below 2^15, components of speeds below 2^12; so a relative speed |w| is below 2^13.5, and a
     * pair that meets has been less than 2^13.6 apart.
     *
     * (1) The time of an impact. The relative positions of a pair on the same course differ by at most e = 2 (x + v) at
     *     every time. r(t), ours, is convex and reaches s = 800 at t with slope -g. Before t - e/g the game's r is
     *     above s. After t + 2 e/g it is below s, if e |w|^2 <= 350 g^2: r'' <= |w|^2 / 700 there. D = (s g)^2; the
     *     roundings of D (16 u |d|^2 w^2) and of the root move a time by less than 2^-29 / g, in both computations
     *     together: e contains 2^-28 more for them. With g >= 16 and e <= g 2^-15 the condition holds
     *     (2^27 e <= 4096 g <= 350 g^2), and the game has its impact within dt = 2 e / g <= 2^-14 of ours. Both are in
     *     the turn if t g > 2 e and (1 - now - t) g > 2 e.
     * (2) The order. Of two impacts more than 2^-12 apart the game's are more than 2^-12 - 2 dt > 1e-5 apart: in the
     *     same order, and not in one window of the rules. So are two of which one is at the start.
     * (3) Pairs that do not meet. At the start the filter of {@link FarPairs} and its proof hold. After an
     *     impact pairs with a new course are set aside only if r stays above 800.1. With e < 2^-6 more than 0.08 is
     *     left. Between our impact and the game's, up to 2^-14, a course of the game may still be the old one (which
     *     surely has no impact before) or begin earlier: r is convex and its slope changes by at most
     *     2^27 / 800 2^-14 < 11 in that time, so it cannot fall by 7e-4 in between. (The same holds for pairs that
     *     meet later: they are g 2^-12 >= 3.9e-3 apart.)
     *     A pair that is not set aside does not meet if it is apart (at the start: by more than roundings; later: by
     *     more than e + 1e-3) and recedes: d.w > 1024, of which the difference of positions and velocities takes at
     *     most 2 (|w| x + |d| v) < 200. Whether a pair touches at the start, where positions are the game's, is sure
     *     if it does not depend on a rounding.
     * (4) The impulse. Relative positions, each at its own impact, differ by z = e + |w| dt, the normals by
     *     n = z / 750, as both are 800 long (to 1e-6, or the same at the start). A change of velocity is
     *     (f + max(120, f)) / mass along the normal, with f = (normal . w) / (1/m + 1/m'): at most 2 |w| + 120, and
     *     differs by at most n (2 |w| + 120) + 2 (n |w| + 2 v). So the new v is 5 v + n (4 |w| + 120), and 2^-30 for
     *     roundings.
     * (5) Positions after an impact. Positions at the two impacts differ by x + v + |V| dt, those on the new courses
     *     V', at the same time, by |V'| dt more. Whether the rules apply the positional correction, 1e-5 each, depends
     *     on the last bit of the distance: half of it is applied here. So the new x is
     *     x + v + (|V| + |V'|) dt + 5.1e-6. At the start positions are the game's, dt = 0, and the correction is the
     *     game's except for roundings.
     * (6) After its impact a pair recedes by at least 120 (1/m + 1/m') >= 24 and is, computed, farther apart than 800
     *     by the rules' own test: it does not meet again before one of the two changes its course.
     * (7) At the end, v + x and 2^-27 for the drag's product and the sums bound the error of positions and of 0.85
     *     times the velocities. The error of the distance of a point from a path is at most that of its corners,
     *     positional corrections included. A path has one corner per impact, the position after the correction; by (2)
     *     a pod has no two impacts at the same time.
     */

    private static final double FASTEST = 0x1p12;
    private static final double FIRST_V = 0x1p-26;
    private static final double FIRST_X = 0x1p-30;
    private static final double ROUNDING = 0x1p-28;
    private static final double LEAST_APPROACH = 16;
    private static final double MOST_PER_APPROACH = 0x1p-15;
    private static final double GREATEST_ERROR = 0x1p-8;
    private static final double APART = 0x1p-12;
    private static final double RECEDING = 1024;
    /** Pairs on a new course are set aside if they stay farther apart than this, see (3). */
    private static final double CLEAR = 800.1;
    private static final double CLEAR_SQUARE = CLEAR * CLEAR;
    private static final double AWAY = 1e-3;
    private static final double TOUCH_DOUBT = 0x1p-20;
    private static final int MOST_IMPACTS = 8;

    private final int pods;
    private final PodPaths paths;
    private final double[] x;
    private final double[] y;
    private final double[] vx;
    private final double[] vy;
    private final double[] inverseMass;
    private final ScanPairs scan;

    private double errorX;
    private double errorV;
    private int touched;
    /** Results of the last {@link #isSure}. */
    private double time;
    private double approach;

    CertifiedImpacts(int pods, PodPaths paths) {
        this.pods = pods;
        this.paths = paths;
        x = new double[pods];
        y = new double[pods];
        vx = new double[pods];
        vy = new double[pods];
        inverseMass = new double[pods];
        scan = ScanPairs.of(pods);
    }

    /** Sets a pod at the start of the turn. @return whether its numbers are small enough */
    boolean set(int pod, double placeX, double placeY, double speedX, double speedY, double ofMass) {
        x[pod] = placeX;
        y[pod] = placeY;
        vx[pod] = speedX;
        vy[pod] = speedY;
        inverseMass[pod] = ofMass;
        return Math.abs(placeX) < PodTurn.SMALL && Math.abs(placeY) < PodTurn.SMALL && isSlow(pod);
    }

    private boolean isSlow(int pod) {
        return Math.abs(vx[pod]) < FASTEST && Math.abs(vy[pod]) < FASTEST;
    }

    /** The pods that had an impact, as bits. */
    int touched() {
        return touched;
    }

    /** The rounded position of a touched pod at the end of the turn. */
    double x(int pod) {
        return x[pod];
    }

    double y(int pod) {
        return y[pod];
    }

    double vx(int pod) {
        return vx[pod];
    }

    double vy(int pod) {
        return vy[pod];
    }

    /** Bound on the error of positions and velocities at the end, before rounding, see (7). */
    private double error() {
        return errorX + errorV + 0x1p-27;
    }

    /** Bound on the error of a corner of a path. */
    double cornerError() {
        return error() + 2 * PUSH_OUT;
    }

    /**
     * Plays the turn for all pods. Corners go to the paths.
     *
     * @param near the pairs that may meet, as bits in the order of the scan
     * @return whether everything is certified; if not, the results are invalid
     */
    boolean fly(long near) {
        errorX = FIRST_X;
        errorV = FIRST_V;
        touched = 0;
        double now = 0;
        long live = near;
        for (int impacts = 0; impacts < MOST_IMPACTS; impacts++) {
            double error = 2 * (errorX + errorV) + ROUNDING;
            double soonest = Double.POSITIVE_INFINITY;
            double itsApproach = 0;
            double next = Double.POSITIVE_INFINITY;
            int pair = -1;
            for (long rest = live; rest != 0; rest &= rest - 1) {
                int candidate = Long.numberOfTrailingZeros(rest);
                if (!isSure(candidate, impacts == 0, error, 1 - now)) {
                    return false;
                }
                if (time < soonest) {
                    next = soonest;
                    soonest = time;
                    itsApproach = approach;
                    pair = candidate;
                } else if (time < next) {
                    next = time;
                }
            }
            if (pair < 0) {
                advance(1 - now);
                return areRounded();
            }
            if (!(next - soonest > APART)) {
                return false;
            }
            advance(soonest);
            now += soonest;
            react(scan.first(pair), scan.second(pair), now, impacts == 0 && soonest == 0, error, itsApproach);
            if (!(errorX + errorV < GREATEST_ERROR && isSlow(scan.first(pair)) && isSlow(scan.second(pair)))) {
                return false;
            }
            long changed = scan.pairsOf(scan.first(pair)) | scan.pairsOf(scan.second(pair));
            live = live & ~changed | nearPairsAmong(changed & ~(1L << pair), 1 - now);
        }
        return false;
    }

    /**
     * True if it is certain that, and about when, a pair meets or that it does not. Sets {@link #time} from now,
     * infinite for never, and the speed of {@link #approach}.
     */
    private boolean isSure(int pair, boolean start, double error, double left) {
        int i = scan.first(pair);
        int j = scan.second(pair);
        double dx = x[i] - x[j];
        double dy = y[i] - y[j];
        double wx = vx[i] - vx[j];
        double wy = vy[i] - vy[j];
        double square = dx * dx + dy * dy;
        double b = dx * wx + dy * wy;
        double c = square - TOUCH_SQUARE;
        time = Double.POSITIVE_INFINITY;
        if (start && c < -TOUCH_DOUBT) {
            time = 0;
            return true;
        }
        if (b > RECEDING) {
            return c > (start ? TOUCH_DOUBT : 2 * TOUCH * (error + AWAY));
        }
        double a = wx * wx + wy * wy;
        double discriminant = b * b - a * c;
        if (!(discriminant > LEAST_APPROACH * LEAST_APPROACH * TOUCH_SQUARE)) {
            return false;
        }
        double root = Math.sqrt(discriminant);
        approach = root * (1 / TOUCH);
        time = (-b - root) / a;
        return error <= approach * MOST_PER_APPROACH && time * approach > 2 * error
            && (left - time) * approach > 2 * error;
    }

    /** Applies drag and rounding to the touched pods. @return whether the results of all roundings are certain */
    private boolean areRounded() {
        double doubt = error();
        boolean sure = true;
        for (int rest = touched; rest != 0; rest &= rest - 1) {
            int pod = Integer.numberOfTrailingZeros(rest);
            double placeX = x[pod] + 0.5;
            double placeY = y[pod] + 0.5;
            double slowX = vx[pod] * PodTurn.KEEP;
            double slowY = vy[pod] * PodTurn.KEEP;
            sure &= isFarFromWhole(placeX, doubt) & isFarFromWhole(placeY, doubt) & isFarFromWhole(slowX, doubt)
                & isFarFromWhole(slowY, doubt);
            x[pod] = Math.floor(placeX) + 0.0;
            y[pod] = Math.floor(placeY) + 0.0;
            vx[pod] = (int) slowX;
            vy[pod] = (int) slowY;
        }
        return sure;
    }

    private static boolean isFarFromWhole(double value, double doubt) {
        return Math.abs(value - Math.rint(value)) > doubt;
    }

    private void advance(double until) {
        for (int pod = 0; pod < pods; pod++) {
            x[pod] += vx[pod] * until;
            y[pod] += vy[pod] * until;
        }
    }

    private void react(int a, int b, double now, boolean start, double error, double slope) {
        double dx = x[b] - x[a];
        double dy = y[b] - y[a];
        double wx = vx[a] - vx[b];
        double wy = vy[a] - vy[b];
        double square = dx * dx + dy * dy;
        double distance = Math.sqrt(square);
        double nx = square == 0 ? 1 : dx / distance;
        double ny = square == 0 ? 0 : dy / distance;
        double step = (nx * wx + ny * wy) / (inverseMass[a] + inverseMass[b]);
        double impulse = step + Math.max(MINIMUM_IMPULSE, step);
        double before = speed(a, b);
        vx[a] -= nx * impulse * inverseMass[a];
        vy[a] -= ny * impulse * inverseMass[a];
        vx[b] += nx * impulse * inverseMass[b];
        vy[b] += ny * impulse * inverseMass[b];
        touched |= 1 << a | 1 << b;
        double w = Math.abs(wx) + Math.abs(wy);
        double late = start ? 0 : 2 * error / slope;
        double normal = start ? 0 : (error + w * late) * (1.0 / 750);
        errorX += errorV + (before + speed(a, b)) * late + (start ? 0x1p-30 : 0.51 * PUSH_OUT);
        errorV = 5 * errorV + normal * (4 * w + MINIMUM_IMPULSE) + 0x1p-30;
        double each = start ? (TOUCH - distance) / 2 + PUSH_OUT : PUSH_OUT / 2;
        x[a] -= nx * each;
        y[a] -= ny * each;
        x[b] += nx * each;
        y[b] += ny * each;
        paths.knot(a, now, x[a], y[a]);
        paths.knot(b, now, x[b], y[b]);
    }

    /** An upper bound of the greater speed of two pods. */
    private double speed(int a, int b) {
        return Math.max(Math.abs(vx[a]) + Math.abs(vy[a]), Math.abs(vx[b]) + Math.abs(vy[b]));
    }

    private long nearPairsAmong(long among, double left) {
        long near = 0;
        for (long rest = among; rest != 0; rest &= rest - 1) {
            int pair = Long.numberOfTrailingZeros(rest);
            int i = scan.first(pair);
            int j = scan.second(pair);
            if (FarPairs.mayMeet(x[i] - x[j], y[i] - y[j], vx[i] - vx[j], vy[i] - vy[j], left, CLEAR_SQUARE)) {
                near |= 1L << pair;
            }
        }
        return near;
    }
}
