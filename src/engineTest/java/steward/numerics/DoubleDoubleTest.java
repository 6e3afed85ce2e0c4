package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;

/** Every operation against decimals of 60 digits: within the bound that its class states, in units of 2^-106. */
@Execution(ExecutionMode.CONCURRENT)
class DoubleDoubleTest {

    private static final int CASES = 5_000;

    private double worst;

    private void check(double bound, DoubleDouble found, java.math.BigDecimal exact, String what) {
        double error = Numbers.error(found, exact);
        worst = Math.max(worst, error);
        assertTrue(error <= bound, what + ": " + error + " * 2^-106, bound " + bound);
        assertEquals(found.high(), found.high() + found.low(), what + ": high is the rounded sum");
    }

    @Test
    @Tag("sized")
    void sumsAreWithinTheirBounds() {
        int cases = TestSize.of(CASES / 5, CASES);
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < cases; k++) {
            DoubleDouble a = Numbers.anyDoubleDouble(random, -60, 60);
            DoubleDouble b = Numbers.anyDoubleDouble(random, -60, 60);
            if (k % 5 == 0) {
                b.set(a).negate().add(Numbers.any(random, -160, -60));
            }
            double c = Numbers.any(random, -100, 100);
            check(2, new DoubleDouble().set(a).add(c), Numbers.of(a).add(Numbers.of(c)), "+ double");
            check(3.01, new DoubleDouble().set(a).add(b), Numbers.of(a).add(Numbers.of(b)), "+");
            check(3.01, new DoubleDouble().set(a).subtract(b), Numbers.of(a).subtract(Numbers.of(b)), "-");
            check(0, new DoubleDouble().setDifference(c, a.high()), Numbers.of(c).subtract(Numbers.of(a.high())),
                "c - a");
        }
        assertTrue(worst > 0.5, "worst " + worst);
    }

    @Test
    @Tag("sized")
    void productsQuotientsAndRootsAreWithinTheirBounds() {
        int cases = TestSize.of(CASES / 5, CASES);
        SplitMix64 random = new SplitMix64(2);
        for (int k = 0; k < cases; k++) {
            DoubleDouble a = Numbers.anyDoubleDouble(random, -200, 200);
            DoubleDouble b = Numbers.anyDoubleDouble(random, -200, 200);
            double c = Numbers.any(random, -200, 200);
            check(0, new DoubleDouble().setProduct(c, a.high()), Numbers.of(c).multiply(Numbers.of(a.high())), "exact");
            check(1.51, new DoubleDouble().set(a).multiply(c), Numbers.of(a).multiply(Numbers.of(c)), "* double");
            check(5, new DoubleDouble().set(a).multiply(b), Numbers.of(a).multiply(Numbers.of(b)), "*");
            DoubleDouble same = new DoubleDouble().set(a);
            check(5, same.multiply(same), Numbers.of(a).multiply(Numbers.of(a)), "square");
            check(15.1, new DoubleDouble().set(a).divide(b), Numbers.of(a).divide(Numbers.of(b), Numbers.DIGITS), "/");
            if (a.high() < 0) {
                a.negate();
            }
            check(3.13, new DoubleDouble().set(a).squareRoot(), Numbers.of(a).sqrt(Numbers.DIGITS), "root");
        }
        assertTrue(worst > 1, "worst " + worst);
    }

    @Test
    void theOrderIsThatOfTheNumbers() {
        SplitMix64 random = new SplitMix64(3);
        for (int k = 0; k < CASES; k++) {
            DoubleDouble a = Numbers.anyDoubleDouble(random, -2, 2);
            DoubleDouble b = k % 2 == 0 ? Numbers.anyDoubleDouble(random, -2, 2)
                : new DoubleDouble().set(a).add(0x1p-90 * random.nextInt(-1, 1));
            assertEquals(Numbers.of(a).compareTo(Numbers.of(b)), a.compareTo(b), k + "");
        }
        assertEquals(0, new DoubleDouble().set(-0.0).compareTo(new DoubleDouble().set(0.0)));
        assertEquals(0, new DoubleDouble().set(0).squareRoot().high());
    }
}
