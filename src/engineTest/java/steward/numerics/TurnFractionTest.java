package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Fractions of a turn against a division by pi in whole numbers. */
class TurnFractionTest {

    private final TurnFraction turns = new TurnFraction();

    @Test
    @Tag("slow")
    void itIsTheFractionOfTheQuotient() {
        SplitMix64 random = new SplitMix64(5);
        for (int exponent = -28; exponent < 1024; exponent++) {
            for (int k = 0; k < 20; k++) {
                check(Math.scalb(1 + random.nextDouble(), exponent));
            }
        }
        check(0x1p-28);
        check(Double.MAX_VALUE);
    }

    /** At most 2^-203 less than the true fraction. */
    private void check(double angle) {
        turns.set(angle);
        BigInteger found = BigInteger.ZERO;
        for (long word : new long[] {turns.first(), turns.second(), turns.third(), turns.fourth()}) {
            found = found.shiftLeft(64).add(new BigInteger(Long.toUnsignedString(word)));
        }
        int exponent = Math.getExponent(angle) - 52;
        int digits = 400 + Math.max(0, exponent);
        BigInteger whole = BigInteger.valueOf((long) Math.scalb(angle, -exponent)).shiftLeft(exponent + digits);
        BigInteger turn = SineCosineOracle.pi(digits).shiftLeft(1);
        BigInteger expected = whole.mod(turn).shiftLeft(256).divide(turn);
        BigInteger error = expected.subtract(found);
        assertTrue(error.signum() >= 0 && error.bitLength() <= 256 - 203, () -> angle + ": " + error);
    }
}
