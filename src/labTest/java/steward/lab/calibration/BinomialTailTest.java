package steward.lab.calibration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Binomial probabilities, and what a sample shows of a share. */
class BinomialTailTest {

    /** P(X &lt;= k) for p = 1/2 is a sum of binomial coefficients over 2^n, here in whole numbers. */
    @Test
    void theSumIsThatOfTheCoefficients() {
        int n = 300;
        BigInteger coefficient = BigInteger.ONE;
        BigInteger sum = BigInteger.ONE;
        for (int k = 0; k < n; k++) {
            double exact = new BigDecimal(sum).divide(new BigDecimal(BigInteger.TWO.pow(n)),
                new MathContext(20)).doubleValue();
            assertEquals(1, BinomialInterval.atMost(k, n, 0.5) / exact, 1e-11, "k = " + k);
            coefficient = coefficient.multiply(BigInteger.valueOf(n - k)).divide(BigInteger.valueOf(k + 1));
            sum = sum.add(coefficient);
        }
        assertEquals(1, BinomialInterval.atMost(n, n, 0.5), 1e-11);
    }

    /** No error in n states shows a share s at 99% from 0.99 &lt;= 1 - s^n on: n = log 0.01 / log s, rounded up. */
    @ParameterizedTest
    @CsvSource({"0.5, 7", "0.9, 44", "0.99, 459", "0.999, 4603", "0.9999, 46050"})
    void soManyStatesAreNeededToShowAShare(double share, int states) {
        assertEquals(-1, BinomialTail.allowed(states - 1, share));
        assertEquals(0, BinomialTail.allowed(states, share));
    }

    /** The last allowed count has a probability of at most 1%, the next one more. */
    @ParameterizedTest
    @CsvSource({"1000, 0.9", "100000, 0.5", "100000, 0.999", "10000000, 0.9999"})
    void theBoundIsWhereTheProbabilityIsOnePercent(int states, double share) {
        int allowed = BinomialTail.allowed(states, share);
        assertTrue(allowed < states * (1 - share));
        assertTrue(BinomialInterval.atMost(allowed, states, 1 - share) <= 0.01);
        assertTrue(BinomialInterval.atMost(allowed + 1, states, 1 - share) > 0.01);
    }

    /** 1 of 100 may exceed: 10 of 1000 are no surprise, 25 are one (P = 0.00003), no error at all never is. */
    @Test
    void onlyWhatChanceDoesNotExplainRefutesAShare() {
        assertFalse(BinomialInterval.refuted(0, 1000, 0.99, 0.999));
        assertFalse(BinomialInterval.refuted(10, 1000, 0.99, 0.999));
        assertFalse(BinomialInterval.refuted(20, 1000, 0.99, 0.999));
        assertTrue(BinomialInterval.refuted(25, 1000, 0.99, 0.999));
        assertTrue(BinomialInterval.refuted(1000, 1000, 0.99, 0.999));
    }
}
