package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** The sequence of the JDK's generator, held against the JDK's. */
class JavaRandomTest {

    private static final long[] SEEDS = {0, 1, -1, 16115355, 719761286, Long.MIN_VALUE, Long.MAX_VALUE, 0x5DEECE66DL};

    @Test
    void everyKindOfDrawIsTheJdks() {
        for (long seed : SEEDS) {
            Random expected = new Random(seed);
            JavaRandom found = new JavaRandom(seed);
            for (int draw = 0; draw < 2000; draw++) {
                String what = "seed " + seed + ", draw " + draw;
                assertEquals(expected.nextInt(3), found.nextInt(3), what);
                assertEquals(expected.nextInt(16), found.nextInt(16), what);
                assertEquals(expected.nextInt(1 << 30), found.nextInt(1 << 30), what);
                assertEquals(expected.nextDouble(), found.nextDouble(), what);
            }
        }
    }

    /** Just above 2^30 half of all numbers are thrown away. */
    @Test
    void numbersBeyondTheLastMultipleAreDrawnAgain() {
        Random expected = new Random(7);
        JavaRandom found = new JavaRandom(7);
        for (int draw = 0; draw < 10_000; draw++) {
            assertEquals(expected.nextInt((1 << 30) + 1), found.nextInt((1 << 30) + 1), "draw " + draw);
        }
    }

    @Test
    void aBoundBelowOneIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new JavaRandom(1).nextInt(0));
    }
}
