package steward.physics;

import java.util.Arrays;
import java.util.Objects;
import steward.Internal;

/**
 * Log of the impacts, path knots and facts of a turn, and of whether the bound on impacts was reached. Its flat arrays
 * are reused from turn to turn. All impacts are counted, and the first are kept, up to a number; all knots are kept,
 * since a path without one of its corners is another path.
 */
public final class TurnLog implements TurnSink {

    /** How many impacts of a turn a replay holds, and so how many the log of a game has to keep. */
    public static final int RECORDED = 2000;

    private static final int[] NO_BODIES = {};

    private final int most;
    private double[] impactTime = new double[16];
    private int[] impactPair = new int[2 * 16];
    private double[] impactNumbers = new double[Impact.NUMBERS * 16];
    private int impacts;

    private int[] knotBody = new int[32];
    private double[] knotNumbers = new double[3 * 32];
    private int knots;

    private static final int FACT_NUMBERS = 5;
    private int[] factIds = new int[3 * 8];
    private double[] factNumbers = new double[FACT_NUMBERS * 8];
    private int facts;

    private double restEnergy;
    private double limitTime = Double.NaN;
    private int[] limitBodies = NO_BODIES;

    /** A log that keeps every impact. */
    public TurnLog() {
        this(Integer.MAX_VALUE);
    }

    /**
     * A log that keeps the first impacts of a turn.
     *
     * @param most how many
     * @throws IllegalArgumentException if that is negative
     */
    public TurnLog(int most) {
        if (most < 0) {
            throw new IllegalArgumentException("a log of " + most + " impacts, expected at least 0");
        }
        this.most = most;
    }

    public void clear() {
        impacts = 0;
        knots = 0;
        facts = 0;
        restEnergy = 0;
        limitTime = Double.NaN;
        limitBodies = NO_BODIES;
    }

    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                       double normalX, double normalY, double impulse, double energy, double massA, double massB,
                       double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                       double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
        if (impacts >= most) {
            impacts++;
            return;
        }
        if (impacts == impactTime.length) {
            impactTime = Arrays.copyOf(impactTime, 2 * impacts);
            impactPair = Arrays.copyOf(impactPair, 4 * impacts);
            impactNumbers = Arrays.copyOf(impactNumbers, 2 * Impact.NUMBERS * impacts);
        }
        impactTime[impacts] = time;
        impactPair[2 * impacts] = a;
        impactPair[2 * impacts + 1] = b;
        double[] to = impactNumbers;
        int k = Impact.NUMBERS * impacts++;
        to[k++] = ax;
        to[k++] = ay;
        to[k++] = bx;
        to[k++] = by;
        to[k++] = normalX;
        to[k++] = normalY;
        to[k++] = impulse;
        to[k++] = energy;
        to[k++] = massA;
        to[k++] = massB;
        to[k++] = vaxBefore;
        to[k++] = vayBefore;
        to[k++] = vaxAfter;
        to[k++] = vayAfter;
        to[k++] = vbxBefore;
        to[k++] = vbyBefore;
        to[k++] = vbxAfter;
        to[k] = vbyAfter;
    }

    @Override
    public void knot(int bodyId, double time, double x, double y) {
        if (knots == knotBody.length) {
            knotBody = Arrays.copyOf(knotBody, 2 * knots);
            knotNumbers = Arrays.copyOf(knotNumbers, 6 * knots);
        }
        knotBody[knots] = bodyId;
        knotNumbers[3 * knots] = time;
        knotNumbers[3 * knots + 1] = x;
        knotNumbers[3 * knots + 2] = y;
        knots++;
    }

    @Override
    public void fact(double time, int kind, int a, int b, double x, double y, double p, double q) {
        if (3 * facts == factIds.length) {
            factIds = Arrays.copyOf(factIds, 6 * facts);
            factNumbers = Arrays.copyOf(factNumbers, 2 * FACT_NUMBERS * facts);
        }
        factIds[3 * facts] = kind;
        factIds[3 * facts + 1] = a;
        factIds[3 * facts + 2] = b;
        int k = FACT_NUMBERS * facts++;
        factNumbers[k++] = time;
        factNumbers[k++] = x;
        factNumbers[k++] = y;
        factNumbers[k++] = p;
        factNumbers[k] = q;
    }

    @Override
    public void rest(double time, double energy) {
        restEnergy += energy;
    }

    @Override
    public void impactLimit(double time, int[] bodyIds) {
        limitTime = time;
        limitBodies = bodyIds;
    }

    public int impacts() {
        return impacts;
    }

    /** Returns how many of these are kept: the first ones. */
    public int kept() {
        return Math.min(impacts, most);
    }

    /**
     * The k-th impact of the turn, in the order of time.
     *
     * @throws IndexOutOfBoundsException unless {@code k} is below {@link #kept}
     */
    public Impact impact(int k) {
        Objects.checkIndex(k, kept());
        double[] n = impactNumbers;
        int i = Impact.NUMBERS * k;
        return new Impact(impactTime[k], impactPair[2 * k], impactPair[2 * k + 1], n[i], n[i + 1], n[i + 2], n[i + 3],
            n[i + 4], n[i + 5], n[i + 6], n[i + 7], n[i + 8], n[i + 9], n[i + 10], n[i + 11], n[i + 12], n[i + 13],
            n[i + 14], n[i + 15], n[i + 16], n[i + 17]);
    }

    /** The time of the k-th impact within the turn, 0..1; unlike {@link #impact}, these four make no record. */
    @Internal
    public double impactTime(int k) {
        return impactTime[k];
    }

    /** The first id of the k-th impact. */
    @Internal
    public int impactA(int k) {
        return impactPair[2 * k];
    }

    /** The second id of the k-th impact, or as {@link Impact#b} of one with a wall. */
    @Internal
    public int impactB(int k) {
        return impactPair[2 * k + 1];
    }

    /** A number of the k-th impact. @param component of {@link Impact}, from 0 for {@link Impact#ax} on */
    @Internal
    public double impactNumber(int k, int component) {
        return impactNumbers[Impact.NUMBERS * k + component];
    }

    /** Returns how many knots all paths of the turn have together. */
    public int knots() {
        return knots;
    }

    /** The id of the body whose path has the k-th knot. */
    public int knotBody(int k) {
        return knotBody[k];
    }

    /** The time of the k-th knot within the turn, 0..1. */
    public double knotTime(int k) {
        return knotNumbers[3 * k];
    }

    /** The x coordinate of the k-th knot, in u. */
    public double knotX(int k) {
        return knotNumbers[3 * k + 1];
    }

    /** The y coordinate of the k-th knot, in u. */
    public double knotY(int k) {
        return knotNumbers[3 * k + 2];
    }

    /** Returns how many facts the game's reaction has told. */
    public int facts() {
        return facts;
    }

    /** The kind of the k-th fact, as the other components in the order of {@link TurnSink#fact}. */
    public int factKind(int k) {
        return factIds[3 * k];
    }

    /** The first id of the k-th fact. */
    public int factA(int k) {
        return factIds[3 * k + 1];
    }

    /** The second id of the k-th fact. */
    public int factB(int k) {
        return factIds[3 * k + 2];
    }

    /** Returns when the k-th fact happened within the turn, 0..1. */
    public double factTime(int k) {
        return factNumbers[FACT_NUMBERS * k];
    }

    public double factX(int k) {
        return factNumbers[FACT_NUMBERS * k + 1];
    }

    public double factY(int k) {
        return factNumbers[FACT_NUMBERS * k + 2];
    }

    public double factP(int k) {
        return factNumbers[FACT_NUMBERS * k + 3];
    }

    public double factQ(int k) {
        return factNumbers[FACT_NUMBERS * k + 4];
    }

    /** The energy that rest took in the turn, as {@link TurnSink#rest} tells it. */
    public double restEnergy() {
        return restEnergy;
    }

    /** True if the turn ended at the bound on impacts. */
    public boolean limited() {
        return !Double.isNaN(limitTime);
    }

    /** Returns when the bound was reached, or NaN if it was not. */
    public double limitTime() {
        return limitTime;
    }

    /** Ids of the bodies that kept their place from then on, ascending. */
    public int[] limitBodies() {
        return limitBodies.clone();
    }
}
