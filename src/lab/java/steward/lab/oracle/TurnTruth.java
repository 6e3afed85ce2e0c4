package steward.lab.oracle;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.stream.IntStream;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.scene.Accuracy;

/*
 * A true number t is kept as t = h + l, h the double nearest to t and l the one nearest to the rest, so that |f - t| of
 * a double f is (f - h) - l with one rounding of a number of its own size. The error of the energy is summed as m (f -
 * t)(f + t) / 2, in which only a true number is subtracted from a computed one.
 */

/**
 * The true turn from a given start, computed by the {@link Oracle} (but see {@link #of}), with which any rung can be
 * compared. Slow to create, fast to query. Immutable.
 */
public final class TurnTruth {

    private static final BigDecimal SNAP = new BigDecimal("1e-5");

    /** The most bodies of a heap that the oracle brings to rest where many turns are compared. */
    public static final int HEAP = 12;

    private final List<OracleBody> end;
    private final int size;
    private final int[] ids;
    private final double[] high;
    private final double[] low;
    private final double[] mass;
    private final double energy;
    private final long[] pairs;
    private final boolean limited;

    private TurnTruth(List<OracleBody> end, int[] ids, long[] pairs, boolean limited) {
        this.end = end;
        this.ids = ids;
        this.pairs = pairs;
        this.limited = limited;
        size = end.size();
        high = new double[4 * size];
        low = new double[4 * size];
        mass = new double[size];
        BigDecimal sum = BigDecimal.ZERO;
        for (int k = 0; k < size; k++) {
            OracleBody body = end.get(k);
            mass[k] = body.mass == null ? Double.POSITIVE_INFINITY : body.mass.doubleValue();
            keep(4 * k, body.x);
            keep(4 * k + 1, body.y);
            keep(4 * k + 2, body.vx);
            keep(4 * k + 3, body.vy);
            sum = sum.add(body.energy());
        }
        energy = sum.doubleValue();
    }

    private void keep(int k, BigDecimal value) {
        high[k] = value.doubleValue();
        low[k] = value.subtract(Decimals.of(high[k])).doubleValue();
    }

    /**
     * Plays the turn; the bodies are not changed. If a body slides along a rim in it, or a heap of more than
     * {@value #HEAP} bodies comes to rest, it is played on {@code exact}.
     *
     * @param parts their law, walls, contacts and reaction are used; the arithmetic is not
     * @throws IllegalArgumentException if the reaction lets bodies bounce at a distance of their own
     */
    public static TurnTruth of(Bodies start, PhysicsParts parts) {
        List<OracleBody> bodies = OracleBody.of(start);
        OracleContacts contacts = parts.contacts().allBounce() ? null : new OracleContacts(parts, start);
        Oracle oracle = new Oracle(parts.law(), parts.walls(), contacts, parts.forces()).withHeapsUpTo(HEAP);
        List<OracleImpact> impacts = oracle.turn(bodies);
        if (oracle.rested()) {
            return ofExact(start, parts);
        }
        int[] ids = IntStream.range(0, bodies.size()).map(contacts == null ? start::id : contacts::id).toArray();
        long[] pairs = impacts.stream()
            .mapToLong(impact -> pair(start.id(impact.a()), impact.b() < 0 ? impact.b() : start.id(impact.b())))
            .sorted().toArray();
        return new TurnTruth(bodies, ids, pairs, oracle.limited());
    }

    private static TurnTruth ofExact(Bodies start, PhysicsParts parts) {
        Bodies end = start.copy();
        TurnLog log = new TurnLog();
        exact(parts, start).turn(end, log);
        return new TurnTruth(OracleBody.of(end), IntStream.range(0, end.size()).map(end::id).toArray(), found(log),
            log.limited());
    }

    /** The advance that stands for the truth where the oracle stops. */
    public static Advance exact(PhysicsParts parts, Bodies bodies) {
        return Accuracy.event(Arithmetic.EXACT).advance(parts.withArithmetic(Arithmetic.EXACT), bodies.size());
    }

    public int impacts() {
        return pairs.length;
    }

    /** True if the turn reached the limit on impacts; then nothing may be compared with it. */
    public boolean limited() {
        return limited;
    }

    /** Compares a computed turn with the true one. */
    public TurnError error(Bodies after, TurnLog log) {
        return new TurnError(positionError(after), beyond(pairs, found(log)), beyond(found(log), pairs),
            energyError(after));
    }

    /**
     * The largest error of a body's centre, in u; infinite if it is not a number, or if a reaction has added or removed
     * other bodies than in truth.
     */
    public double positionError(Bodies after) {
        if (!areSame(after)) {
            return Double.POSITIVE_INFINITY;
        }
        double most = 0;
        for (int k = 0; k < size; k++) {
            double dx = off(4 * k, after.x[k]);
            double dy = off(4 * k + 1, after.y[k]);
            double distance = Math.sqrt(dx * dx + dy * dy);
            most = distance <= most ? most : Double.isNaN(distance) ? Double.POSITIVE_INFINITY : distance;
        }
        return most;
    }

    private boolean areSame(Bodies after) {
        boolean same = after.size() == size;
        for (int k = 0; same && k < size; k++) {
            same = after.id(k) == ids[k];
        }
        return same;
    }

    private double energyError(Bodies after) {
        if (!areSame(after)) {
            return Double.POSITIVE_INFINITY;
        }
        double wrong = 0;
        for (int k = 0; k < size; k++) {
            if (mass[k] < Double.POSITIVE_INFINITY) {
                wrong += mass[k] * (off(4 * k + 2, after.vx[k]) * (after.vx[k] + high[4 * k + 2])
                    + off(4 * k + 3, after.vy[k]) * (after.vy[k] + high[4 * k + 3])) / 2;
            }
        }
        return wrong == 0 ? 0 : Double.isNaN(wrong) ? Double.POSITIVE_INFINITY : Math.abs(wrong) / energy;
    }

    private double off(int k, double found) {
        return found - high[k] - low[k];
    }

    /**
     * Returns how many bodies end the turn with numbers that differ from the true ones, after the scene's rounding of
     * both; all, if other bodies are there than in truth. The true drag is the decimal in the scene: 0.15 of 100 leaves
     * 85.
     *
     * @param start  the bodies before the turn: their drag is used
     * @param ended  the bodies after the turn and after {@link Motion#endTurn}
     * @param motion the scene's motion, which rounds both positions and velocities
     */
    public int differing(Bodies start, Bodies ended, Motion motion) {
        if (!areSame(ended)) {
            return start.size();
        }
        Motion.Step position = motion.step(Motion.Of.POSITION);
        Motion.Step velocity = motion.step(Motion.Of.VELOCITY);
        int count = 0;
        for (int k = 0; k < size; k++) {
            OracleBody body = end.get(k);
            BigDecimal keep = BigDecimal.ONE.subtract(BigDecimal.valueOf(motion.drag() ? ended.drag[k] : 0));
            boolean same = whole(body.x, position) == ended.x[k] && whole(body.y, position) == ended.y[k]
                && whole(body.vx.multiply(keep), velocity) == ended.vx[k]
                && whole(body.vy.multiply(keep), velocity) == ended.vy[k];
            count += same ? 0 : 1;
        }
        return count;
    }

    private static double whole(BigDecimal value, Motion.Step step) {
        BigDecimal away = value.setScale(0, RoundingMode.HALF_UP);
        return switch (step) {
            case ROUND_POSITION -> value.add(BigDecimal.valueOf(0.5)).setScale(0, RoundingMode.FLOOR).doubleValue();
            case ROUND_POSITION_AWAY, ROUND_VELOCITY -> away.doubleValue();
            case SNAP_POSITION, SNAP_VELOCITY -> (away.subtract(value).abs().compareTo(SNAP) < 0 ? away
                : value.setScale(0, RoundingMode.DOWN)).doubleValue();
            default -> value.setScale(0, RoundingMode.DOWN).doubleValue();
        };
    }

    private static long[] found(TurnLog log) {
        return IntStream.range(0, log.impacts()).mapToLong(k -> pair(log.impactA(k), log.impactB(k)))
            .sorted().toArray();
    }

    /** Two ids in either order, or an id and {@code ~wall}, as one number. */
    private static long pair(int a, int b) {
        return b < 0 ? (long) a << Integer.SIZE | b & 0xffff_ffffL
            : (long) Math.min(a, b) << Integer.SIZE | Math.max(a, b);
    }

    /** Returns how many elements of the first array have no partner in the second; both ascending. */
    private static int beyond(long[] ones, long[] others) {
        int count = 0;
        int k = 0;
        for (long one : ones) {
            while (k < others.length && others[k] < one) {
                k++;
            }
            if (k < others.length && others[k] == one) {
                k++;
            } else {
                count++;
            }
        }
        return count;
    }
}
