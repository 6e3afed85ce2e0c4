package steward.lab.oracle;

import java.math.BigDecimal;
import java.math.MathContext;

/** Errors of doubles against decimals of the oracle. */
public final class DecimalErrors {

    private DecimalErrors() { }

    /** The distance of a double from the true number, in units in the last place of the double nearest to the truth. */
    public static double ulps(double found, BigDecimal truth) {
        double nearest = truth.doubleValue();
        if (!Double.isFinite(found) || !Double.isFinite(nearest)) {
            return found == nearest ? 0 : Double.POSITIVE_INFINITY;
        }
        return Decimals.of(found).subtract(truth).abs().divide(Decimals.of(Math.ulp(nearest)), MathContext.DECIMAL64)
            .doubleValue();
    }

    /** |found - truth| / scale. */
    public static double relative(double found, BigDecimal truth, BigDecimal scale) {
        if (!Double.isFinite(found)) {
            return Double.POSITIVE_INFINITY;
        }
        BigDecimal off = Decimals.of(found).subtract(truth).abs();
        return off.signum() == 0 ? 0 : scale.signum() == 0 ? Double.POSITIVE_INFINITY
            : off.divide(scale.abs(), MathContext.DECIMAL64).doubleValue();
    }
}
