package steward.physics.event;

/**
 * Tests that exclude pairs of circles which cannot meet in the rest of a turn, without a square root. They decide as
 * the official expressions do, which would find no impact.
 */
public final class FarPairs {

    /** A pair is set aside if its squared distance always exceeds s^2 + MARGIN + SHARE d^2. See the proof below. */
    private static final double MARGIN = 1;
    private static final double SHARE = 0x1p-40;
    private static final double KEPT_SHARE = 1 - SHARE;

    private FarPairs() { }

    /*
     * Which pairs are set aside. With d, w the relative position and velocity of a pair, f(t) = |d + w t|^2 and s the
     * touching distance, a pair is set aside for the rest T of the turn only if the smallest f on [0, T] is above
     * s^2 + m, with m = 1 + 2^-40 |d|^2, as computed. u = 2^-53 is the unit of rounding.
     *
     * (1) Computed and true values of f differ by a few u (|d| + |w| T')^2, T' <= T the time of the smallest f; as T'
     *     is not later than the closest approach, |w| T' <= |d|, and so truly f >= s^2 + 0.9 m.
     * (2) Then the official expressions find no impact. Their test of the distance uses f(0). They compute a = w.w,
     *     b = d.w, c = d.d - s^2, D = b^2 - a c and the root t = (-b - sqrt D) / a. Let q = -b / |w| <= |d| and
     *     h^2 = D / a, the true value of s^2 less the square of the impact parameter. Each product in D is at most
     *     |d|^2 a, so that the computed D / a is off by less than 16 u |d|^2 < 2^-48 |d|^2 < m / 256. If q > |w| T, the
     *     smallest f is at T: 0.9 m <= f(T) - s^2 = (q - |w| T)^2 - h^2, and with the computed h it is still
     *     0.8 m <= (q - |w| T - h)(q - |w| T + h), so that q - h exceeds |w| T by at least 0.8 m / (|d| + s), more than
     *     2^-42 |d|; rounding of b, of the sum, of the quotient and of 1 - t moves it by less than 2^-48 |d|: the root
     *     is later than T. If 0 <= q <= |w| T then f(q / |w|) - s^2 = -h^2 >= 0.9 m: the computed D is below 0. If
     *     q < 0, the two recede and c > 0.9 m: the computed root is negative or there is none.
     * (3) A pair that was set aside stays so while both keep their velocity: the true f of the rest of the turn is the
     *     same as before, except for the rounding of positions from impact to impact. Below 2^16 u that is less than
     *     2^-37 u per coordinate and flight, in at most 21,000 flights and for both bodies less than 2^-21 u; with
     *     |d| < 2^18 it changes f by less than 1/4, which leaves m / 2, enough for (2). Beyond these limits all pairs
     *     are tested each time.
     *
     * Velocities that are known only to 2^-26 u per turn keep the bound: f changes by less than 2^-24 |d| <= 1/64.
     */

    /** True if a pair may come within the margin of the other before {@code time} has passed. */
    public static boolean mayMeet(double dx, double dy, double wx, double wy, double time, double touchSquare) {
        double c = KEPT_SHARE * (dx * dx + dy * dy) - (touchSquare + MARGIN);
        double b = dx * wx + dy * wy;
        if (c + (b - Math.abs(b)) * time > 0) {
            return false;                             // most pairs, see areFar
        }
        if (!(c > 0)) {
            return true;
        }
        double a = wx * wx + wy * wy;
        return -b >= a * time ? !((a * time + 2 * b) * time + c > 0) : !(b * b - a * c < 0);
    }

    /** Returns the parameter {@code reach} of {@link #areFar} for circles that touch at this squared distance. */
    public static double reach(double touchSquare) {
        return touchSquare + MARGIN;
    }

    /**
     * A cheap test that a pair cannot meet in a turn: f(t) = d^2 + 2 b t + w^2 t^2 with b = d.w is at least d^2 + 2 b
     * if the two approach, and at least d^2 if they do not; and b - |b| is 2 b or 0. Where the test holds,
     * |b| is at most |d|^2 / 2, so that the roundings are no greater than in (1).
     */
    public static boolean areFar(double dx, double dy, double wx, double wy, double reach) {
        double b = dx * wx + dy * wy;
        return KEPT_SHARE * (dx * dx + dy * dy) - reach + (b - Math.abs(b)) > 0;
    }
}
