package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigInteger;
import org.junit.jupiter.api.Test;

/** The constants of the table, computed anew by {@link SineCosineOracle}, and their symmetries. */
class SineTableTest {

    private final double[] rows = SineTable.rows();

    @Test
    void sinesAndCosinesOfTheFirstQuarterAreRight() {
        SineCosineOracle oracle = new SineCosineOracle();
        for (int k = 0; k <= 64; k++) {
            int direction = k;
            oracle.turn(SineCosineOracle.pi(SineCosineOracle.DIGITS).multiply(BigInteger.valueOf(k)).shiftRight(7));
            double sine = oracle.distanceFromSine(rows[4 * k], rows[4 * k + 1]);
            double cosine = oracle.distanceFromCosine(rows[4 * k + 2], rows[4 * k + 3]);
            assertTrue(sine <= 0x1p-81 && cosine <= 0x1p-81, () -> direction + ": " + sine + ", " + cosine);
        }
    }

    @Test
    void firstPartsAreShortAndRestsAreSmall() {
        for (int at = 0; at < rows.length; at += 2) {
            assertEquals(Math.rint(rows[at] * 0x1p26), rows[at] * 0x1p26, "number " + at);
            assertTrue(Math.abs(rows[at]) <= 1 && Math.abs(rows[at + 1]) <= 0x1p-27, "number " + at);
        }
    }

    /** sin(x + pi/2) = cos x, cos(x + pi/2) = -sin x. */
    @Test
    void aQuarterTurnSwapsSineAndCosine() {
        for (int k = 0; k < 256; k++) {
            int next = (k + 64) % 256;
            for (int part = 0; part < 2; part++) {
                assertTrue(rows[4 * next + part] == rows[4 * k + 2 + part], "sine of " + next);
                assertTrue(rows[4 * next + 2 + part] == -rows[4 * k + part], "cosine of " + next);
            }
        }
    }
}
