package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/**
 * Angles whose sine or cosine is next to a double or to the middle between two: the hardest to round. Sources: the
 * lists {@code sin.wc} and {@code cos.wc} of CORE-MATH, binary64, which for angles up to pi are those of V. Lefevre
 * (testlibm-data, 2020); and V. Lefevre, J.-M. Muller, "Worst Cases for Correct Rounding of the Elementary Functions in
 * Double Precision" (2001). That they are hard is checked here, as are the results.
 */
class SineCosineWorstCasesTest {

    /** From CORE-MATH: the hardest of some, then some beyond 128. */
    private static final double[] SINES = {
        0x1.598bae9e632f6p-7, 0x1.54b3504c6b4a3p-1, 0x1.0102947e7003bp-3, 0x1.043e268ba402ap1, 0x1.5369a841f76f5p-9,
        0x1.1a2c4c1f1db7ep-14, 0x1.00e730f98fd44p-9, 0x1.039d88c480fccp-22, 0x1.f9ae9db2c4bbep7, 0x1.1da5d5a23306dp0,
        0x1.009ee184a02e7p-8, 0x1.5d9b876341713p1, 0x1.50d73b22a04bap-5, 0x1.00874a5f9fc33p-13, 0x1.63ee34129c226p-1,
        0x1.6f5dc3cf788a9p-19, 0x1.2ebea3f228638p1, 0x1.5a6f19f60d638p-1, 0x1.46552b86d2836p1, 0x1.34b19761f1f4bp0,
        0x1.0ae9bf0c6c208p-6, 0x1.115317fdb5dc7p-13, 0x1.8b088a3284a2ap7, 0x1.d0240c320008ap7, 0x1.e932499b3fffp7,
        0x1.b71d04d35b028p7, 0x1.4ad16230457e2p7, 0x1.9e8f718c00d45p7, 0x1.47a81768df001p7};

    /** From CORE-MATH: the hardest of some, then some beyond 1024. */
    private static final double[] COSINES = {
        0x1.34ec2f9fc9c00p1, 0x1.3aca9ac4d718dp0, 0x1.5f6f40c07e007p-11, 0x1.ff632411ff523p10, 0x1.48e6a8a73f91ep-17,
        0x1.30bed7646b2aep0, 0x1.0f16c6f632009p0, 0x1.00147eec5cfa5p0, 0x1.0f5ba326bf09fp-3, 0x1.1baf00b2f6b01p-1,
        0x1.00786b0bf421p-2, 0x1.062a2f8ff7e5p0, 0x1.0b55a4268b1b6p-4, 0x1.146de9a66c2e3p0, 0x1.41bf5603f5ddp0,
        0x1.0799a2750d20cp-16, 0x1.11a08114c99bcp0, 0x1.673b9fe297c3ep0, 0x1.03f81f636b80cp-24, 0x1.15842cb04f9cep-2,
        0x1.0009effd4bedap-12, 0x1.0203b71ba100fp-1, 0x1.6a0799d5e895ap10, 0x1.fa27ee3a20944p10, 0x1.00333ecf5cd58p10,
        0x1.770a45d712056p10, 0x1.ef734d4151abdp10, 0x1.2af32e3c03613p10, 0x1.e42c71638ccc7p10, 0x1.4d9e07ed47a93p10,
        0x1.08b07e51c8fbep10, 0x1.3b79fedb1ce6fp10};

    /** From Lefevre and Muller: next to a double. */
    private static final double[] SINES_NEXT_TO_A_DOUBLE = {0x1.e0000000001c2p-20, 0x1.fe767739d0f6dp-2};
    private static final double[] COSINES_NEXT_TO_A_DOUBLE = {0x1.8000000000009p-23, 0x1.8000000000024p-22};

    /** Digits after the 53 that are all equal, or equal but for the first. */
    private static final int EQUAL_DIGITS = 44;

    private final SineCosineOracle oracle = new SineCosineOracle();
    private final SineCosine angles = new SineCosine();
    private final SineCosine bySeries = new SineCosine(Double.POSITIVE_INFINITY);

    @Test
    void sinesAreRoundedRight() {
        for (double[] list : new double[][] {SINES, SINES_NEXT_TO_A_DOUBLE}) {
            for (double angle : list) {
                check(angle);
                assertTrue(oracle.nearnessOfSine() < -EQUAL_DIGITS, () -> "hard at " + Double.toHexString(angle));
                check(-angle);
            }
        }
    }

    @Test
    void cosinesAreRoundedRight() {
        for (double[] list : new double[][] {COSINES, COSINES_NEXT_TO_A_DOUBLE}) {
            for (double angle : list) {
                check(angle);
                assertTrue(oracle.nearnessOfCosine() < -EQUAL_DIGITS, () -> "hard at " + Double.toHexString(angle));
                check(-angle);
            }
        }
    }

    /** 60 digits after the 53: hence the 186 of {@link SineCosineSeries}, with room. */
    @Test
    void theHardestOfAllNeedsSixtyDigitsMore() {
        oracle.turn(0x1.598bae9e632f6p-7);
        assertEquals(-60.06, oracle.nearnessOfSine(), 0.01);
        oracle.turn(0x1.34ec2f9fc9cp1);
        assertEquals(-59.78, oracle.nearnessOfCosine(), 0.01);
    }

    private void check(double angle) {
        oracle.turn(angle);
        for (SineCosine either : new SineCosine[] {angles, bySeries}) {
            either.turn(angle);
            assertEquals(oracle.sin(), either.sin(), () -> "sin " + Double.toHexString(angle));
            assertEquals(oracle.cos(), either.cos(), () -> "cos " + Double.toHexString(angle));
        }
    }
}
