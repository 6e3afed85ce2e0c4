package steward.league.rating;

/** The standard normal distribution, and Student's t distribution approximated through it. */
public final class Normal {

    private static final double ROOT_OF_TWO_PI = 2.5066282746310002;
    /** Beyond this the series needs too many terms, and the continued fraction few. */
    private static final double FAR = 4;
    private static final int TERMS = 200;
    /** Beyond this a tail is 0. */
    private static final double FARTHEST = 38;
    private static final int HALVINGS = 70;

    private Normal() { }

    public static double density(double x) {
        return StrictMath.exp(-x * x / 2) / ROOT_OF_TWO_PI;
    }

    /**
     * The probability below x. Near 0 by 1/2 + density(x) (x + x^3/3 + x^5/(3 5) + ...), far out by the continued
     * fraction density(x) / (x + 1/(x + 2/(x + 3/...))) of the tail (Abramowitz and Stegun, Handbook of Mathematical
     * Functions, 26.2.11 and 26.2.14).
     */
    public static double below(double x) {
        return x > 0 ? 1 - tail(x) : tail(-x);
    }

    /** The probability below x times e^exponent, also where the one would be 0 and the other infinite. */
    public static double scaledBelow(double exponent, double x) {
        if (x >= -FAR) {
            return StrictMath.exp(exponent) * below(x);
        }
        return StrictMath.exp(exponent - x * x / 2) / (ROOT_OF_TWO_PI * fraction(-x));
    }

    private static double fraction(double x) {
        double fraction = x;
        for (int k = TERMS; k > 0; k--) {
            fraction = x + k / fraction;
        }
        return fraction;
    }

    /** The probability above x, for x of at least 0. */
    private static double tail(double x) {
        if (x > FARTHEST) {
            return 0;
        }
        if (x > FAR) {
            return density(x) / fraction(x);
        }
        double term = x;
        double sum = x;
        for (int k = 3; Math.abs(term) > 1e-18; k += 2) {
            term *= x * x / k;
            sum += term;
        }
        return Math.max(0, 0.5 - density(x) * sum);
    }

    /** Returns the point above which the probability is {@code tail}, of more than 0 and at most 1/2. */
    public static double above(double tail) {
        double low = 0;
        double high = FARTHEST;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (low + high) / 2;
            if (tail(middle) > tail) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return (low + high) / 2;
    }

    /**
     * Returns the quantile of Student's t that is as far out as z is in the normal distribution (D. L. Wallace, "Bounds
     * on normal approximations to Student's and the chi-square distributions", Annals of Mathematical Statistics 30,
     * 1959, solved for t): z = sqrt(f log(1 + t^2/f)) (8 f + 1)/(8 f + 3).
     *
     * @param freedom degrees of freedom f
     */
    public static double student(double z, double freedom) {
        double corrected = z * (8 * freedom + 3) / (8 * freedom + 1);
        double exponent = corrected * corrected / freedom;
        return exponent > 700 ? Double.POSITIVE_INFINITY : Math.sqrt(freedom * StrictMath.expm1(exponent));
    }

    /** The z that is as far out as Student's t with so many degrees of freedom: the reverse of {@link #student}. */
    public static double ofStudent(double t, double freedom) {
        return Math.signum(t) * Math.sqrt(freedom * StrictMath.log1p(t * t / freedom)) * (8 * freedom + 1)
            / (8 * freedom + 3);
    }
}
