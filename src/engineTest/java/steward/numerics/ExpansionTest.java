package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.match.TestSize;

/** Sums and products of expansions are exact: nothing of them is lost, and the sign is that of the decimals. */
class ExpansionTest {

    /** The value, as what is left after taking off double-doubles until nothing is. */
    private static BigDecimal value(Expansion expansion) {
        BigDecimal sum = BigDecimal.ZERO;
        DoubleDouble part = new DoubleDouble();
        for (int k = 0; k < 200 && expansion.sign() != 0; k++) {
            expansion.roundTo(part);
            sum = sum.add(Numbers.of(part));
            expansion.add(-part.high()).add(-part.low());
        }
        assertEquals(0, expansion.sign());
        return sum;
    }

    @Test
    @Tag("sized")
    void sumsOfProductsAreExact() {
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < TestSize.of(800, 3000); k++) {
            Expansion sum = new Expansion();
            BigDecimal exact = BigDecimal.ZERO;
            for (int term = 0; term < 12; term++) {
                double a = Numbers.any(random, -150, 150);
                double b = Numbers.any(random, -150, 150);
                sum.addProduct(a, b).add(a);
                exact = exact.add(Numbers.of(a).multiply(Numbers.of(b))).add(Numbers.of(a));
            }
            assertEquals(exact.signum(), sum.sign(), "case " + k);
            assertTrue(Numbers.error(sum.roundTo(new DoubleDouble()), exact) < 8, "case " + k);
            assertEquals(0, exact.compareTo(value(sum)), "case " + k);
        }
    }

    /** (a + b)(a - b) - (a a - b b) is 0, and not 0 with the least digit added: where doubles see nothing at all. */
    @Test
    @Tag("sized")
    void whatCancelsToTheLastBitIsSeen() {
        SplitMix64 random = new SplitMix64(2);
        for (int k = 0; k < TestSize.of(800, 3000); k++) {
            DoubleDouble a = Numbers.anyDoubleDouble(random, -20, 20);
            DoubleDouble b = Numbers.anyDoubleDouble(random, -20, 20);
            Expansion plus = new Expansion().add(a.low()).add(a.high()).add(b.low()).add(b.high());
            Expansion minus = new Expansion().add(a.low()).add(a.high()).add(-b.low()).add(-b.high());
            Expansion sum = new Expansion().addProduct(plus, minus).subtractProduct(a, a).addProduct(b, b);
            assertEquals(0, sum.sign(), "case " + k);
            assertEquals(1, sum.add(0x1p-400).sign());
            assertEquals(-1, sum.add(-0x1p-399).sign());
            assertEquals(-0x1p-400, sum.roundTo(new DoubleDouble()).high());
        }
    }
}
