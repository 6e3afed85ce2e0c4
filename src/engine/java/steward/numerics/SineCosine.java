package steward.numerics;

/**
 * Sine and cosine, correctly rounded: for every finite double the double nearest to the true value. So the result has
 * the same bits everywhere, whatever the algorithm. For 0.0 and -0.0 the sine is the argument itself; for an argument
 * that is not finite both are NaN.
 *
 * <p>The method is A. Ziv's ("Fast evaluation of elementary mathematical functions with correctly rounded last bit",
 * 1991). A quick value with a proven bound on its error decides the rounding for all but one of some five thousand
 * angles; {@link SineCosineSeries} computes the others. The quick value comes from a table and short polynomials, in
 * the manner of P. T. P. Tang ("Table-lookup algorithms for elementary functions and their error analysis", 1991). It
 * uses no fused multiply-add: products that have to be exact are those of short numbers.
 *
 * <p>Not thread-safe: sine and cosine are left in fields. Allocates nothing.
 */
public final class SineCosine {

    private static final double[] TABLE = SineTable.rows();
    private static final int LAST_DIRECTION = SineTable.DIRECTIONS - 1;

    /** The angle between two directions, pi/128: its first 35 digits, the rest; and its reciprocal. */
    private static final double STEP = 0x1.921fb5444p-6;
    private static final double STEP_REST = 0x1.68c234c4c6629p-45;
    private static final double STEPS_PER_RADIAN = 0x1.45f306dc9c883p5;
    /** Up to here the number of steps, below 2^16, has exact products with the first part of a step. */
    private static final double GREATEST_ANGLE = 0x1p10;
    /** Below, sin x is nearer to x and cos x to 1 than to any other double: x^3/6 < 2^-56 x and x^2/2 < 2^-55. */
    private static final double LEAST_ANGLE = 0x1p-27;

    /** Added to a small number and taken away again, it rounds to whole numbers. */
    private static final double TO_WHOLE = 0x1.8p52;
    /** Rounds to multiples of 2^-26 when it is added to a small number and taken away again. */
    private static final double TO_GRID = 0x1.8p26;

    /** Coefficients of sin r - r, Taylor's, and of cos r - 1 + r^2/2, the best ones with 1/50 of Taylor's error. */
    private static final double S3 = -1.0 / 6;
    private static final double S5 = 1.0 / 120;
    private static final double S7 = -1.0 / 5040;
    private static final double C4 = 0x1.5555555549e75p-5;
    private static final double C6 = -0x1.6c165d6916d32p-10;

    /** pi/4 in binary digits, 64 each. */
    private static final long QUARTER_PI = 0xc90fdaa22168c234L;
    private static final long QUARTER_PI_REST = 0xc4c6628b80dc1cd1L;

    /*
     * Let u = 2^-53, k the number of steps nearest to the angle, r = angle - k pi/128, and S, C sine and cosine of
     * k pi/128. Then
     *
     *     sin(angle) = S cos r + C sin r,    cos(angle) = C cos r - S sin r.
     *
     * Each of S, C, cos r, sin r is split in two, S = S1 + S2 and so on, the first part a multiple of 2^-26, the second
     * small. Then S1 cos1 and C1 sin1 are multiples of 2^-52 and at most 1: they are exact, and so is their sum, the
     * head. All else is below 2^-21.5, and its roundings are small: the rest. What follows bounds its error; it is the
     * same for both functions, as |S|, |C| <= 1.
     *
     * (1) r. The product of angle and 128/pi, below 2^15.4, is off by less than 2^-36.7, so that |r| < pi/256 + 2^-41
     *     < 2^-6.348. near = angle - k STEP: the product is exact. Where k is not 0 the angle is above 2^-7; then both
     *     are multiples of 2^-59, and the difference, below 2^-6.3, is exact. low = k STEP_REST is below 2^-29; its
     *     rounding is at most 2^-83, and that of STEP_REST makes 2^-82.6. r1, near rounded to the grid, is exact, and
     *     so is near - r1, at most 2^-27. r2 = (near - r1) - low is rounded by at most 2^-80. So
     *     |r1 + r2 - r| < 2^-79.6. The double r is off by 1.01 u 2^-6.348 at most.
     * (2) sin1 = r1 and sin2 = r2 + (sin r - r). The polynomial for sin r - r, below 2^-21.63 in size, is off by
     *     2^-77.0, its roundings by 7.6 u 2^-21.63 < 2^-71.7 (r 1.01 u, its square 3.02 u, their product 5.03 u, the
     *     two sums 0.75 u each, the last product 1 u). The sum with r2 is rounded by at most 2^-75.
     * (3) cos1 = 1 - r1^2/2 rounded to the grid, without other error: r1 is a whole number below 2^20 times 2^-26.
     *     cos2 = (1 - cos1 - r1^2/2) - r2 (r1 + r)/2 + (cos r - 1 + r^2/2). The first is exact and at most 2^-27. The
     *     second is below 2^-32.9 and off by 2^-84. The polynomial for the third, which is below 2^-29.9, is the best
     *     of its kind and off by 2^-71.8, its roundings by 8.8 u 2^-29.98 < 2^-79.8. The sums are rounded by
     *     2^-83 and 2^-80. In all, without the 2^-71.8, below 2^-78.7.
     * (4) rest = (S2 cos1 + C2 sin1) + (S cos2 + C sin2), where S2 and C2, at most 2^-27, are rounded by at most 2^-81.
     *     What is rounded at that size (S2 and its product, their sum, S and C as doubles and the product with cos2)
     *     makes twice 2^-81, twice 2^-80 and 2^-80.8: below 2^-78.1. C as a double is off by 2^-54, times sin2 2^-75.6.
     *     The product with sin2, the last two sums, and the sum of rest and ERROR are rounded by at most 2^-75 each.
     *
     * The sum of all, 2^-79.6 + 2^-77.0 + 2^-71.7 + 2^-71.8 + 2^-78.7 + 2^-78.1 + 2^-75.6 + 5 2^-75, is below 2^-70.3.
     * Rounding is monotonic: if head and rest with ERROR added and with ERROR taken away are rounded to the same
     * double, this is also the one nearest to the true value, which lies between.
     */

    /** More than the error of a head and rest: see above. */
    static final double ERROR = 0x1p-70;

    private final double error;
    private final TurnFraction turns = new TurnFraction();
    private final SineCosineSeries series = new SineCosineSeries();
    private double sin;
    private double cos;
    /** Of the last angle that was left to the series: for tests. */
    double sineHead;
    double sineRest;
    double cosineHead;
    double cosineRest;

    /** Sine and cosine of no angle yet. */
    public SineCosine() {
        this(ERROR);
    }

    /** @param error of head and rest, as far as the decision goes: with infinity all is left to the series */
    SineCosine(double error) {
        this.error = error;
    }

    /** The cosine of the last {@link #turn}. */
    public double cos() {
        return cos;
    }

    /** The sine of the last {@link #turn}. */
    public double sin() {
        return sin;
    }

    /** Computes both of an angle in radians: see {@link #cos()}, {@link #sin()}. */
    public void turn(double angle) {
        if (!(Math.abs(angle) <= GREATEST_ANGLE)) {
            turnFar(angle);
            return;
        }
        double shifted = angle * STEPS_PER_RADIAN + TO_WHOLE;
        double steps = shifted - TO_WHOLE;
        double near = angle - steps * STEP;
        double low = steps * STEP_REST;
        double r1 = near + TO_GRID - TO_GRID;
        double r2 = near - r1 - low;
        combine(angle, (int) Double.doubleToRawLongBits(shifted), near - low, r1, r2);
    }

    /** @param direction of which the lower eight bits count */
    private void combine(double angle, int direction, double r, double r1, double r2) {
        double square = r * r;
        double half = 0.5 * r1 * r1;
        double fourth = square * square;
        double sineTail = r * square * (S3 + square * S5 + fourth * S7);
        double cosineTail = fourth * (C4 + square * C6);
        double sin2 = r2 + sineTail;
        double cos1 = 1 + TO_GRID - half - TO_GRID;
        double cos2 = 1 - cos1 - half + (cosineTail - 0.5 * (r2 * (r1 + r)));
        int at = SineTable.NUMBERS * (direction & LAST_DIRECTION);
        double s1 = TABLE[at];
        double s2 = TABLE[at + 1];
        double c1 = TABLE[at + 2];
        double c2 = TABLE[at + 3];
        double s = s1 + s2;
        double c = c1 + c2;
        decide(angle, s1 * cos1 + c1 * r1, s2 * cos1 + c2 * r1 + (s * cos2 + c * sin2),
            c1 * cos1 - s1 * r1, c2 * cos1 - s2 * r1 + (c * cos2 - s * sin2));
    }

    /** Takes the rounded sums of heads and rests, if rests greater and less by the error make the same. */
    private void decide(double angle, double headOfSine, double restOfSine, double headOfCosine, double restOfCosine) {
        sin = headOfSine + (restOfSine + error);
        cos = headOfCosine + (restOfCosine + error);
        if (sin > headOfSine + (restOfSine - error) || cos > headOfCosine + (restOfCosine - error)) {
            sineHead = headOfSine;
            sineRest = restOfSine;
            cosineHead = headOfCosine;
            cosineRest = restOfCosine;
            turnBySeries(angle);
        }
    }

    private void turnBySeries(double angle) {
        if (Math.abs(angle) < LEAST_ANGLE) {
            sin = angle;
            cos = 1;
            return;
        }
        series.turn(angle);
        sin = series.sin();
        cos = series.cos();
    }

    /*
     * Far out the angle comes as a fraction of a turn in binary digits. The first eight, rounded, are the direction.
     * With d the difference, |d| <= 2^-9 turns, r = 2 pi d is 8 times (pi/4) d. The first 128 digits of that product
     * are off by less than 2^-125, r by less than 2^-122. Of these, r1 has the digits down to 2^-26, rounded, and r2
     * those from there down to 2^-89, rounded to a double: by less than 2^-80, as in (1).
     */

    /** Turns by an angle beyond {@link #GREATEST_ANGLE}, or by what is not finite. */
    private void turnFar(double angle) {
        if (!(Math.abs(angle) < Double.POSITIVE_INFINITY)) {
            sin = Double.NaN;
            cos = Double.NaN;
            return;
        }
        turns.set(Math.abs(angle));
        int direction = (int) (turns.first() + (1L << 55) >>> 56);
        long difference = turns.first() - ((long) direction << 56);
        long sign = difference >> 63;
        long upper = difference ^ sign;
        long lower = turns.second() ^ sign;
        long product = upper * QUARTER_PI;
        long rest = product + WideFraction.multiplyHigh(upper, QUARTER_PI_REST);
        long carry = WideFraction.carry(rest, product);
        product = WideFraction.multiplyHigh(lower, QUARTER_PI);
        rest += product;
        carry += WideFraction.carry(rest, product);
        product = WideFraction.multiplyHigh(upper, QUARTER_PI) + carry;
        long first = product + (1L << 34) >> 35;
        long second = (product - (first << 35) << 28) + (rest >>> 36);
        boolean negative = angle < 0;
        double scale = sign < 0 != negative ? -1 : 1;
        double r1 = scale * 0x1p-26 * first;
        double r2 = scale * 0x1p-89 * second;
        combine(angle, negative ? -direction : direction, r1 + r2, r1, r2);
    }
}
