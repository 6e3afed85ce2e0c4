package steward.game.podrace.simulator;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Circle functions to 70 digits, from their series: slow and plain. */
final class ManyDigits {

    static final MathContext DIGITS = new MathContext(70, RoundingMode.HALF_EVEN);
    private static final BigDecimal TINY = BigDecimal.ONE.movePointLeft(75);
    /** Machin: pi = 16 atan(1/5) - 4 atan(1/239). */
    private static final BigDecimal PI = inverseArcTangent(5).multiply(BigDecimal.valueOf(16))
        .subtract(inverseArcTangent(239).multiply(BigDecimal.valueOf(4)));

    private ManyDigits() {
    }

    private static BigDecimal inverseArcTangent(int of) {
        BigDecimal power = BigDecimal.ONE.divide(BigDecimal.valueOf(of), 90, RoundingMode.HALF_EVEN);
        BigDecimal square = BigDecimal.valueOf((long) of * of);
        BigDecimal sum = power;
        for (int k = 3; power.signum() != 0; k += 2) {
            power = power.divide(square, 90, RoundingMode.HALF_EVEN);
            BigDecimal term = power.divide(BigDecimal.valueOf(k), 90, RoundingMode.HALF_EVEN);
            sum = k % 4 == 3 ? sum.subtract(term) : sum.add(term);
        }
        return sum;
    }

    /** Cosine and sine of a double, exactly as it is stored. */
    static BigDecimal[] direction(double angle) {
        BigDecimal exact = new BigDecimal(angle);
        BigDecimal turns = exact.divide(PI.add(PI), 0, RoundingMode.HALF_EVEN);
        BigDecimal rest = exact.subtract(turns.multiply(PI.add(PI)));
        return new BigDecimal[] {series(BigDecimal.ONE, rest, 0), series(rest, rest, 1)};
    }

    /** first - first x^2 / ((n + 1) (n + 2)) + ... */
    private static BigDecimal series(BigDecimal first, BigDecimal x, int n) {
        BigDecimal square = x.multiply(x, DIGITS).negate();
        BigDecimal term = first;
        BigDecimal sum = first;
        for (int k = n; term.abs().compareTo(TINY) > 0; k += 2) {
            term = term.multiply(square, DIGITS).divide(BigDecimal.valueOf((k + 1L) * (k + 2L)), DIGITS);
            sum = sum.add(term);
        }
        return sum;
    }

    static BigDecimal length(BigDecimal x, BigDecimal y) {
        return x.multiply(x).add(y.multiply(y)).sqrt(DIGITS);
    }

    /** The length of the difference between two vectors, as a double. */
    static double apart(BigDecimal[] one, BigDecimal[] other) {
        return length(one[0].subtract(other[0]), one[1].subtract(other[1])).doubleValue();
    }
}
