package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.match.Refusal.refused;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** The generator against its published outputs, and its ranges at their edges. */
class SplitMix64Test {

    /** The output of the reference C program (S. Vigna, splitmix64.c) for seed 1234567, as published. */
    @Test
    void knownAnswers() {
        SplitMix64 random = new SplitMix64(1234567);
        long[] found = {random.nextLong(), random.nextLong(), random.nextLong(), random.nextLong(), random.nextLong()};
        assertArrayEquals(new long[] {6457827717110365317L, 3203168211198807973L,
            Long.parseUnsignedLong("9817491932198370423"), 4593380528125082431L,
            Long.parseUnsignedLong("16408922859458223821")}, found);
    }

    /** The state after k draws is seed + k gamma, and 0 is the mixer's fixed point. */
    @Test
    void theMixerAloneGivesTheSameSequence() {
        assertEquals(0, SplitMix64.mix(0));
        SplitMix64 random = new SplitMix64(-5);
        for (int k = 1; k <= 100; k++) {
            assertEquals(SplitMix64.mix(-5 + k * 0x9E3779B97F4A7C15L), random.nextLong(), "draw " + k);
        }
    }

    /**
     * 70,000 draws below 7: each value is expected 10,000 times with a standard deviation of
     * sqrt(70000 * 1/7 * 6/7) = 93; 5 of them are 465.
     */
    @Test
    void everyValueBelowABoundIsAsLikely() {
        SplitMix64 random = new SplitMix64(3);
        int[] counts = new int[7];
        for (int k = 0; k < 70_000; k++) {
            counts[random.nextInt(7)]++;
        }
        for (int count : counts) {
            assertEquals(10_000, count, 465, Arrays.toString(counts));
        }
    }

    /** The largest bound covers half of the 32-bit numbers: its upper half is reached with probability 1/2 a draw. */
    @Test
    void theSmallestAndLargestBounds() {
        SplitMix64 random = new SplitMix64(4);
        boolean high = false;
        for (int k = 0; k < 1000; k++) {
            assertEquals(0, random.nextInt(1));
            int value = random.nextInt(Integer.MAX_VALUE);
            assertTrue(value >= 0 && value < Integer.MAX_VALUE, "found " + value);
            high |= value > Integer.MAX_VALUE / 2;
        }
        assertTrue(high);
    }

    @Test
    void bothEndsOfARangeAreDrawn() {
        SplitMix64 random = new SplitMix64(5);
        boolean[] seen = new boolean[61];
        for (int k = 0; k < 2000; k++) {
            seen[random.nextInt(-30, 30) + 30] = true;
        }
        for (int k = 0; k < seen.length; k++) {
            assertTrue(seen[k], "never drawn: " + (k - 30));
        }
        assertEquals(9, random.nextInt(9, 9));
        assertTrue(random.nextInt(Integer.MIN_VALUE, -2) < -1);
        assertTrue(random.nextInt(1, Integer.MAX_VALUE) > 0);
    }

    /** A range of 2^31 numbers or more has no positive bound; one that ends before it starts is empty. */
    @Test
    void badRangesAreRefusedWithTheirNumbers() {
        SplitMix64 random = new SplitMix64(6);
        refused("bound 0, expected at least 1", () -> random.nextInt(0));
        refused("bound -7, expected at least 1", () -> random.nextInt(-7));
        refused("range 5..4, expected 1 to 2^31 - 1 numbers", () -> random.nextInt(5, 4));
        refused("range 5..-2147483648, expected 1 to 2^31 - 1 numbers", () -> random.nextInt(5, Integer.MIN_VALUE));
        refused("range 0..2147483647, expected 1 to 2^31 - 1 numbers", () -> random.nextInt(0, Integer.MAX_VALUE));
        refused("range -2147483648..2147483647, expected 1 to 2^31 - 1 numbers",
            () -> random.nextInt(Integer.MIN_VALUE, Integer.MAX_VALUE));
    }

    /** Multiples of 2^-53 below 1; the mean of 10,000 has a standard deviation of 1 / sqrt(12 * 10000) = 0.0029. */
    @Test
    void doublesAreUniformBelowOne() {
        SplitMix64 random = new SplitMix64(7);
        double sum = 0;
        for (int k = 0; k < 10_000; k++) {
            double value = random.nextDouble();
            assertTrue(value >= 0 && value < 1 && value * 0x1p53 == Math.rint(value * 0x1p53), "found " + value);
            sum += value;
        }
        assertEquals(0.5, sum / 10_000, 5 * 0.0029);
    }
}
