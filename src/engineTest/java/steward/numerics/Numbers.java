package steward.numerics;

import java.math.BigDecimal;
import java.math.MathContext;

/** Random doubles over all exponents, and exact decimals of what the numerics hold. */
final class Numbers {

    static final MathContext DIGITS = new MathContext(60);

    private Numbers() {
    }

    /** A finite double, its exponent uniform from low to high; one in four has few digits, so that things cancel. */
    static double any(SplitMix64 random, int low, int high) {
        double digits = random.nextInt(4) == 0 ? 1 + random.nextInt(8) / 8.0 : 1 + random.nextDouble();
        return Math.scalb(random.nextInt(2) == 0 ? digits : -digits, random.nextInt(low, high));
    }

    static BigDecimal of(double value) {
        return new BigDecimal(value);
    }

    static BigDecimal of(DoubleDouble value) {
        return of(value.high()).add(of(value.low()));
    }

    /** A double-double with random digits in both parts. */
    static DoubleDouble anyDoubleDouble(SplitMix64 random, int low, int high) {
        double head = any(random, low, high);
        return new DoubleDouble().setSum(head, head * 0x1p-54 * (2 * random.nextDouble() - 1));
    }

    /** The relative error of a double-double, in units of u^2 = 2^-106. */
    static double error(DoubleDouble found, BigDecimal exact) {
        if (exact.signum() == 0) {
            return found.high() == 0 ? 0 : Double.POSITIVE_INFINITY;
        }
        return of(found).subtract(exact).abs().divide(exact.abs(), DIGITS).doubleValue() * 0x1p106;
    }
}
