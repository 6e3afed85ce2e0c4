package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.match.TestSize;

/**
 * The judge of {@link SineCosine} judged: against plain Taylor series in decimal numbers, without any reduction, and
 * against published digits.
 */
class SineCosineOracleTest {

    private static final MathContext DIGITS = new MathContext(120);
    private static final BigDecimal UNIT = new BigDecimal(BigInteger.ONE.shiftLeft(SineCosineOracle.DIGITS));

    private final SineCosineOracle oracle = new SineCosineOracle();

    /** The first hundred digits, as everywhere. */
    @Test
    void piIsPi() {
        BigDecimal pi = new BigDecimal("3.1415926535897932384626433832795028841971693993751058209749445923078164"
            + "062862089986280348253421170679");
        BigDecimal found = new BigDecimal(SineCosineOracle.pi(400))
            .divide(new BigDecimal(BigInteger.ONE.shiftLeft(400)), DIGITS);
        assertTrue(found.subtract(pi).abs().compareTo(new BigDecimal("1e-99")) < 0, found::toString);
    }

    @Test
    @Tag("sized")
    void sinesAndCosinesAreThoseOfTheTaylorSeries() {
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < TestSize.of(100, 300); k++) {
            double angle = k % 3 < 2 ? (random.nextDouble() - 0.5) * 60 : Numbers.any(random, -30, -1);
            oracle.turn(angle);
            check(angle, taylor(angle, 1), oracle.distanceFromSine(0, 0), oracle.sin());
            check(angle, taylor(angle, 0), oracle.distanceFromCosine(0, 0), oracle.cos());
        }
    }

    /** x^n/n! - x^(n+2)/(n+2)! + ...: of 30, terms up to 10^12, so that at least 100 digits are right. */
    private static BigDecimal taylor(double angle, int first) {
        BigDecimal square = new BigDecimal(angle).pow(2);
        BigDecimal term = first == 0 ? BigDecimal.ONE : new BigDecimal(angle);
        BigDecimal sum = term;
        for (int n = first + 1; term.abs().compareTo(new BigDecimal("1e-110")) > 0; n += 2) {
            term = term.multiply(square, DIGITS).divide(BigDecimal.valueOf(-(long) n * (n + 1)), DIGITS);
            sum = sum.add(term);
        }
        return sum;
    }

    private static void check(double angle, BigDecimal expected, double size, double rounded) {
        assertEquals(expected.abs().doubleValue(), size, Math.ulp(size), () -> "size at " + angle);
        assertEquals(expected.doubleValue(), rounded, () -> "at " + angle);
    }

    /** sin(10^22), of N. J. Higham's and W. Kahan's examples: -0.8522008497671888017727... */
    @Test
    void farOutTooTheyAreThePublishedOnes() {
        oracle.turn(1e22);
        assertEquals(-0.8522008497671888, oracle.sin());
        BigDecimal sine = new BigDecimal(oracle.sine()).divide(UNIT, DIGITS);
        assertTrue(sine.subtract(new BigDecimal("-0.8522008497671888017727")).abs()
            .compareTo(new BigDecimal("1e-22")) < 0, sine::toString);
    }

    /** sin(pi/6) = 1/2 and cos(pi/3) = 1/2; cos of what is above pi/4. */
    @Test
    void ofAnglesInManyDigitsToo() {
        oracle.turn(SineCosineOracle.pi(SineCosineOracle.DIGITS).divide(BigInteger.valueOf(6)));
        assertTrue(oracle.distanceFromSine(0.5, 0) < 0x1p-240);
        oracle.turn(SineCosineOracle.pi(SineCosineOracle.DIGITS).divide(BigInteger.valueOf(3)));
        assertTrue(oracle.distanceFromCosine(0.5, 0) < 0x1p-240);
    }

    /** BigDecimal.doubleValue as the second opinion on rounding, from subnormal numbers up. */
    @Test
    @Tag("sized")
    void tinySinesAreRoundedRight() {
        SplitMix64 random = new SplitMix64(2);
        for (int k = 0; k < TestSize.of(100, 300); k++) {
            double angle = Numbers.any(random, -1074, -20);
            oracle.turn(angle);
            BigDecimal x = new BigDecimal(angle);
            BigDecimal cube = x.pow(3).divide(BigDecimal.valueOf(6), DIGITS);
            BigDecimal fifth = x.pow(5).divide(BigDecimal.valueOf(120), DIGITS);
            assertEquals(x.subtract(cube).add(fifth).doubleValue(), oracle.sin(), () -> "at " + angle);
        }
    }
}
