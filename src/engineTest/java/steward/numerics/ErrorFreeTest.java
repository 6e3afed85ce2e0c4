package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;

/** Sums and products with their errors, against exact decimals and against the processor's fused multiply-add. */
@Execution(ExecutionMode.CONCURRENT)
class ErrorFreeTest {

    @Test
    @Tag("sized")
    void aSumAndItsErrorAreTheExactSum() {
        int cases = TestSize.of(6_000, 50_000);
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < cases; k++) {
            int near = random.nextInt(-900, 900);
            double a = Numbers.any(random, near, near + 100);
            double b = Numbers.any(random, near, near + 100);
            double s = a + b;
            double error = ErrorFree.sumError(a, b, s);
            assertEquals(0, Numbers.of(a).add(Numbers.of(b)).compareTo(Numbers.of(s).add(Numbers.of(error))),
                () -> a + " + " + b);
            if (Math.abs(a) >= Math.abs(b)) {
                assertEquals(error, ErrorFree.fastSumError(a, b, s), () -> a + " + " + b);
            }
        }
    }

    @Test
    @Tag("sized")
    void aProductAndItsErrorAreTheExactProduct() {
        int cases = TestSize.of(6_000, 50_000);
        SplitMix64 random = new SplitMix64(2);
        int checked = 0;
        for (int k = 0; k < cases; k++) {
            double a = Numbers.any(random, -1000, 1000);
            double b = Numbers.any(random, -1000, 1000);
            double p = a * b;
            if (Math.abs(p) >= 0x1p-968 && Double.isFinite(p)) {
                double error = ErrorFree.productError(a, b, p);
                assertEquals(0, Numbers.of(a).multiply(Numbers.of(b)).compareTo(Numbers.of(p).add(Numbers.of(error))),
                    () -> a + " * " + b);
                checked++;
            }
        }
        assertTrue(checked > 0.6 * cases, checked + " in range");
    }

    /**
     * The split gives those bits over all exponents, subnormal and nearly infinite ones too, as long as the product is
     * finite.
     */
    @Test
    void theSplitGivesTheBitsOfAFusedMultiplyAdd() {
        SplitMix64 random = new SplitMix64(3);
        double[] special = {0, -0.0, Double.MIN_VALUE, Double.MIN_NORMAL, Double.MAX_VALUE, 1, -1, 0x1p996, 0x1p-1070,
            0x1p27 + 1, Math.nextDown(2.0), 0x1.8p-1022};
        int small = 0;
        for (int k = 0; k < 200_000; k++) {
            double a = k < 144 ? special[k / 12] : k % 3 == 0 ? Double.longBitsToDouble(random.nextLong())
                : Numbers.any(random, -1074, 1023);
            double b = k < 144 ? special[k % 12] : k % 3 == 1 ? Double.longBitsToDouble(random.nextLong())
                : Numbers.any(random, -1074, 1023);
            double p = a * b;
            if (Double.isFinite(p)) {
                assertEquals(Double.doubleToLongBits(Math.fma(a, b, -p)),
                    Double.doubleToLongBits(ErrorFree.productErrorBySplit(a, b, p)), () -> a + " * " + b);
                small += Math.abs(p) < 0x1p-968 ? 1 : 0;
            }
        }
        assertTrue(small > 5000, small + " products so small that their error is rounded");
    }

    /** Which way is taken is the JVM's answer, and it is the same answer every time. */
    @Test
    void theMachineKnowsItself() {
        assertEquals(ErrorFree.hasFastFma(), ErrorFree.hasFastFma());
        assertEquals(Math.fma(0.1, 0.1, -(0.1 * 0.1)), ErrorFree.productError(0.1, 0.1, 0.1 * 0.1));
    }
}
