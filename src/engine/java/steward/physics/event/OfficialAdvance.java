package steward.physics.event;

import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Collision;
import steward.physics.time.CircleTime;
import steward.physics.time.Magnitudes;

/**
 * The event loop of {@link EventAdvance} for one kind of scene, several times as fast and with the same bits: circles
 * of equal size and finite masses under {@link ImpactLaw#OFFICIAL_POD_RACE} in the official arithmetic, without walls.
 * Pairs that cannot meet are set aside before any square root and tested again only when the velocity of one of the two
 * has changed. Allocates nothing in a turn (except in the rare turns that reach the bound on impacts or are left to
 * {@link EventAdvance}).
 *
 * <p>Caveat: at most {@value #MOST_BODIES} bodies; more, or of different sizes, are left to {@link EventAdvance}.
 */
public final class OfficialAdvance implements Advance {

    /** The maximum number of bodies. */
    public static final int MOST_BODIES = ScanPairs.MOST_BODIES;
    /** The set of all bodies, as bits. */
    public static final int ALL = -1;

    /** A pair is set aside if its squared distance always exceeds s^2 + MARGIN + SHARE d^2. See the proof below. */
    private static final double MARGIN = 1;
    private static final double SHARE = 0x1p-40;
    private static final double KEPT_SHARE = 1 - SHARE;
    /**
     * Up to this magnitude, in u and in u per turn, the rounding of positions over a whole turn is small against the
     * margin.
     */
    private static final double SMALL = 0x1p15;

    private final ImpactLaw law = ImpactLaw.OFFICIAL_POD_RACE;
    private final double window = law.batchWindow();
    private final Collision collision = Collision.of(law, Arithmetic.OFFICIAL, new Wall[0], null);
    private final PhysicsParts parts;
    /** Parts of the general way, made when they are first needed. */
    private Standstill standstill;
    private EventAdvance general;

    private double radius;
    private double touchSquare;
    private double greatestTouching;

    private int size;
    private ScanPairs scan = ScanPairs.of(0);

    /** The impacts found, in the order of time, ties in the order of the scan. */
    private final double[] times = new double[MOST_BODIES * (MOST_BODIES - 1) / 2];
    private final int[] pairs = new int[times.length];
    private int found;

    /** @throws IllegalArgumentException unless the scene {@link #fits} */
    public OfficialAdvance(PhysicsParts parts) {
        if (!fits(parts)) {
            throw new IllegalArgumentException("expected the official law of the pod race in the official arithmetic, "
                + "every contact a bounce, no walls and finite masses");
        }
        this.parts = parts;
    }

    /**
     * For bodies of equal radius.
     *
     * @param radius of every body, in u
     */
    public OfficialAdvance(double radius) {
        this(new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL));
        setRadius(radius);
    }

    /** Sets the radius of every body, in u; {@link #turn} finds it itself. */
    public void setRadius(double ofAll) {
        radius = ofAll;
        double touch = radius + radius;
        touchSquare = touch * touch;
        double greatest = touchSquare;
        while (Math.sqrt(greatest) > touch) {
            greatest = Math.nextDown(greatest);
        }
        while (Math.sqrt(Math.nextUp(greatest)) <= touch) {
            greatest = Math.nextUp(greatest);
        }
        greatestTouching = greatest;
    }

    /** True if this class can replace the {@link EventAdvance} of these parts. */
    public static boolean fits(PhysicsParts parts) {
        return parts.law().equals(ImpactLaw.OFFICIAL_POD_RACE) && parts.arithmetic().isOfficial()
            && parts.contacts().allBounce() && parts.walls().isEmpty() && !parts.infiniteMasses();
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (!haveOneRadius(bodies) || bodies.size() > MOST_BODIES || !Magnitudes.fitPlainArithmetic(bodies)) {
            turnInGeneral(bodies, sink);
            return;
        }
        long near = nearPairs(bodies);
        if (near == 0) {
            EventAdvance.fly(bodies, 1);
        } else {
            turnInPlainArithmetic(bodies, sink, near, ALL);
        }
    }

    private void turnInGeneral(Bodies bodies, TurnSink sink) {
        general = general == null ? new EventAdvance(parts) : general;
        general.turn(bodies, sink);
    }

    private boolean haveOneRadius(Bodies bodies) {
        if (bodies.size() > 0 && bodies.radius[0] != radius) {
            setRadius(bodies.radius[0]);
        }
        for (int body = 1; body < bodies.size(); body++) {
            if (bodies.radius[body] != radius) {
                return false;
            }
        }
        return true;
    }

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
     * The same bound holds for velocities that are known only to 2^-26 u per turn: f changes by less than
     * 2^-24 |d| <= 1/64.
     */

    /**
     * The pairs that may have an impact in this turn: a set as bits, empty only if there is no impact. Velocities may
     * be off by 2^-26 u per turn if no coordinate exceeds 2^16 u and no speed 2^16 u per turn.
     */
    public long nearPairs(Bodies bodies) {
        if (bodies.size() != size) {
            setSize(bodies.size());
        }
        double[] x = bodies.x;
        double[] y = bodies.y;
        double[] vx = bodies.vx;
        double[] vy = bodies.vy;
        long near = 0;
        long bit = 1;
        for (int i = size - 1; i > 0; i--) {
            double xi = x[i];
            double yi = y[i];
            double vxi = vx[i];
            double vyi = vy[i];
            for (int j = i - 1; j >= 0; j--) {
                if (mayMeet(xi - x[j], yi - y[j], vxi - vx[j], vyi - vy[j], 1, touchSquare)) {
                    near |= bit;
                }
                bit <<= 1;
            }
        }
        return near;
    }

    /** True if a pair may come within the margin above before {@code time} has passed. */
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

    /** The parameter {@code reach} of {@link #areFar}. */
    public double reach() {
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

    /** The test that {@link #nearPairs} makes for each pair, from relative position and velocity. */
    public boolean mayMeet(double dx, double dy, double wx, double wy) {
        return mayMeet(dx, dy, wx, wy, 1, touchSquare);
    }

    /** The indices of the bodies in a set of pairs, as bits. */
    public int bodiesOf(long set, int bodies) {
        if (bodies != size) {
            setSize(bodies);
        }
        int members = 0;
        for (long rest = set; rest != 0; rest &= rest - 1) {
            int pair = Long.numberOfTrailingZeros(rest);
            members |= 1 << scan.first(pair) | 1 << scan.second(pair);
        }
        return members;
    }

    /**
     * Plays a turn whose near pairs are known; there is at least one.
     *
     * @param exact the bodies (bits) whose velocities are exact, at least those of the near pairs; the others are off
     *              by at most 2^-26 u per turn. {@link #ALL}: all are exact
     * @return false if the turn has to be played anew with all velocities exact: an impact has sent a body towards one
     *         of the others, or there are numbers whose squares leave the range of doubles; what was done to the bodies
     *         is then to be discarded
     * @throws IllegalArgumentException as {@link Advance#turn}
     */
    public boolean turn(Bodies bodies, TurnSink sink, long near, int exact) {
        if (Magnitudes.fitPlainArithmetic(bodies)) {
            return turnInPlainArithmetic(bodies, sink, near, exact);
        }
        if (exact == ALL) {
            turnInGeneral(bodies, sink);
        }
        return exact == ALL;
    }

    private boolean turnInPlainArithmetic(Bodies bodies, TurnSink sink, long near, int exact) {
        long doubtful = 0;
        for (int body = 0; body < size; body++) {
            doubtful |= (exact >> body & 1) != 0 ? 0 : scan.pairsOf(body);
        }
        int left = law.impactLimit(size);
        boolean small = isSmall(bodies);
        long live = near;
        double now = 0;
        for (;;) {
            find(bodies, live, now);
            if (found == 0) {
                EventAdvance.fly(bodies, 1 - now);
                return true;
            }
            if (left <= 0) {
                standstill = standstill == null ? new Standstill(parts) : standstill;
                standstill.finish(bodies, now, sink);
                return doubtful == 0;
            }
            EventAdvance.fly(bodies, times[0] - now);
            now = times[0];
            long changed = 0;
            for (int k = 0; k < found && times[k] - now <= window; k++, left--) {
                int a = scan.first(pairs[k]);
                int b = scan.second(pairs[k]);
                collision.reactPair(bodies, a, b, times[k], sink);
                changed |= scan.pairsOf(a) | scan.pairsOf(b);
                small &= isSmall(bodies, a) && isSmall(bodies, b);
            }
            live = live & ~changed | nearPairsAmong(bodies, small ? changed : scan.all(), 1 - now);
            if ((live & doubtful) != 0) {
                return false;
            }
        }
    }

    private static boolean isSmall(Bodies bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            if (!isSmall(bodies, i)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isSmall(Bodies bodies, int i) {
        return Math.abs(bodies.x[i]) <= SMALL && Math.abs(bodies.y[i]) <= SMALL && Math.abs(bodies.vx[i]) <= SMALL
            && Math.abs(bodies.vy[i]) <= SMALL;
    }

    private long nearPairsAmong(Bodies bodies, long among, double time) {
        long near = 0;
        for (long rest = among; rest != 0; rest &= rest - 1) {
            int pair = Long.numberOfTrailingZeros(rest);
            int i = scan.first(pair);
            int j = scan.second(pair);
            if (mayMeet(bodies.x[i] - bodies.x[j], bodies.y[i] - bodies.y[j], bodies.vx[i] - bodies.vx[j],
                bodies.vy[i] - bodies.vy[j], time, touchSquare)) {
                near |= 1L << pair;
            }
        }
        return near;
    }

    /** Finds the impacts of the given pairs, by the official expressions. */
    private void find(Bodies bodies, long live, double now) {
        double left = 1 - now;
        found = 0;
        for (long rest = live; rest != 0; rest &= rest - 1) {
            int pair = Long.numberOfTrailingZeros(rest);
            int i = scan.first(pair);
            int j = scan.second(pair);
            double dx = bodies.x[i] - bodies.x[j];
            double dy = bodies.y[i] - bodies.y[j];
            double square = dx * dx + dy * dy;
            double until = square <= greatestTouching ? 0
                : CircleTime.official(dx, dy, bodies.vx[i] - bodies.vx[j], bodies.vy[i] - bodies.vy[j],
                    square - touchSquare);
            if (until <= left) {
                offer(now + until, pair);
            }
        }
    }

    private void offer(double time, int pair) {
        int k = found++;
        while (k > 0 && times[k - 1] > time) {
            times[k] = times[k - 1];
            pairs[k] = pairs[k - 1];
            k--;
        }
        times[k] = time;
        pairs[k] = pair;
    }

    private void setSize(int bodies) {
        scan = ScanPairs.of(bodies);
        size = bodies;
    }
}
