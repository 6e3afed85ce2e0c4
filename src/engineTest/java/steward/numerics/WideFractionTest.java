package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;

/** Fractions of 192 digits against whole numbers of any length. */
@Execution(ExecutionMode.CONCURRENT)
class WideFractionTest {

    private static final int COUNT = 20_000;
    private static final BigInteger ONE = BigInteger.ONE.shiftLeft(192);
    private static final BigInteger SIX_UNITS = BigInteger.valueOf(6).shiftLeft(192);

    private final SplitMix64 random = new SplitMix64(6);

    /** Words of random digits, of zeros and of ones, so that things carry. */
    private long word() {
        return switch (random.nextInt(5)) {
            case 0 -> 0;
            case 1 -> -1;
            case 2 -> random.nextLong() >> random.nextInt(64);
            default -> random.nextLong();
        };
    }

    private WideFraction any() {
        return new WideFraction().set(word(), word(), word());
    }

    private static BigInteger of(WideFraction value) {
        BigInteger sum = BigInteger.ZERO;
        for (long word : new long[] {value.high(), value.middle(), value.low()}) {
            sum = sum.shiftLeft(64).add(new BigInteger(Long.toUnsignedString(word)));
        }
        return sum;
    }

    @Test
    void productsAreLessThanSixUnitsShort() {
        for (int k = 0; k < COUNT; k++) {
            WideFraction a = any();
            WideFraction b = k % 10 == 0 ? a : any();
            BigInteger exact = of(a).multiply(of(b));
            BigInteger found = of(a.multiply(b)).shiftLeft(192);
            BigInteger error = exact.subtract(found);
            assertTrue(error.signum() >= 0 && error.compareTo(SIX_UNITS) < 0, error::toString);
        }
    }

    @Test
    void differencesAreExact() {
        for (int k = 0; k < COUNT; k++) {
            WideFraction a = any();
            WideFraction b = any();
            BigInteger exact = of(a).subtract(of(b)).mod(ONE);
            BigInteger complement = ONE.subtract(of(b)).mod(ONE);
            assertEquals(exact, of(new WideFraction().set(b).subtractFrom(a)));
            assertEquals(complement, of(b.subtractFromOne()));
        }
    }

    @Test
    void quotientsAreCutOff() {
        for (int k = 0; k < COUNT; k++) {
            WideFraction a = any();
            int divisor = 1 + (random.nextInt(2) == 0 ? random.nextInt(60) : random.nextInt(Integer.MAX_VALUE));
            assertEquals(of(a).divide(BigInteger.valueOf(divisor)), of(a.divide(divisor)));
        }
    }

    /** Half way up, where it says so: BigDecimal goes to even there. */
    @Test
    @Tag("sized")
    void theNearestDoubleIsTheNearest() {
        int count = TestSize.of(COUNT / 8, COUNT);
        BigDecimal unit = new BigDecimal(ONE);
        for (int k = 0; k < count; k++) {
            WideFraction a = new WideFraction().set(Math.max(1, word() >>> random.nextInt(64)), word(), word() | 1);
            assertEquals(new BigDecimal(of(a)).divide(unit).doubleValue(), a.toDouble());
            assertEquals(192 - of(a).bitLength(), a.leadingZeros());
        }
        assertEquals(Math.nextUp(0.5), new WideFraction().set(1L << 63 | 1L << 10, 0, 0).toDouble());
        assertEquals(1.0, new WideFraction().set(-1, -1, -1).toDouble());
    }
}
