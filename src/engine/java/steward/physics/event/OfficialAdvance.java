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
 * Fast form of {@link EventAdvance} for the official pod race: the same bits, several times as fast. It takes circles
 * of equal size and finite masses under {@link ImpactLaw#OFFICIAL_POD_RACE} in the official arithmetic, without walls.
 * Pairs that cannot meet are excluded by {@link FarPairs} and tested again only when the velocity of one of the two has
 * changed. Allocates nothing in a turn (except in the rare turns that reach the bound on impacts or are left to {@link
 * EventAdvance}).
 *
 * <p>Caveat: at most {@value #MOST_BODIES} bodies; more, or of different sizes, are left to {@link EventAdvance}.
 */
public final class OfficialAdvance implements Advance {

    /** The maximum number of bodies. */
    public static final int MOST_BODIES = ScanPairs.MOST_BODIES;
    /** The set of all bodies, as bits. */
    public static final int ALL = -1;

    /**
     * Up to this magnitude, in u and in u per turn, the rounding of positions over a whole turn is small against the
     * margin of {@link FarPairs}.
     */
    private static final double SMALL = 0x1p15;

    private final ImpactLaw law = ImpactLaw.OFFICIAL_POD_RACE;
    private final double window = law.batchWindow();
    private final Collision collision = Collision.of(law, Arithmetic.OFFICIAL, new Wall[0], null, null);
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
                if (FarPairs.mayMeet(xi - x[j], yi - y[j], vxi - vx[j], vyi - vy[j], 1, touchSquare)) {
                    near |= bit;
                }
                bit <<= 1;
            }
        }
        return near;
    }

    /** The parameter {@code reach} of {@link FarPairs#areFar}. */
    public double reach() {
        return FarPairs.reach(touchSquare);
    }

    /** The test that {@link #nearPairs} makes for each pair, from relative position and velocity. */
    public boolean mayMeet(double dx, double dy, double wx, double wy) {
        return FarPairs.mayMeet(dx, dy, wx, wy, 1, touchSquare);
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
            if (FarPairs.mayMeet(bodies.x[i] - bodies.x[j], bodies.y[i] - bodies.y[j], bodies.vx[i] - bodies.vx[j],
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
