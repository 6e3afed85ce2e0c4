package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class AnswerTimesTest {

    private static final long MS = 1_000_000;

    /** Below 128 ns every nanosecond has a bucket of its own: of 1 to 100 the 99th is 99. */
    @Test
    void shortTimesAreExact() {
        AnswerTimes times = new AnswerTimes();
        for (int k = 100; k >= 1; k--) {
            times.add(k, 1 + k);
        }
        assertEquals(100, times.count());
        assertEquals(50.5, times.meanNanos());
        assertEquals(99, times.quantileNanos(0.99));
        assertEquals(50, times.quantileNanos(0.5));
        assertEquals(1, times.quantileNanos(0));
        assertEquals(100, times.quantileNanos(1));
        assertEquals(100, times.worstNanos());
        assertEquals(101, times.worstTurn());
    }

    /** 990 of 1000 answers of 1 ms, 10 of 20 ms: the 990th is 1 ms, the 991st would be 20; never beyond the worst. */
    @Test
    void theNinetyNinthPercentIsTheNearestRank() {
        AnswerTimes times = new AnswerTimes();
        for (int k = 0; k < 1000; k++) {
            times.add(k % 100 == 7 ? 20 * MS : MS, 2);
        }
        assertEquals(MS, times.quantileNanos(0.99), MS / 64.0);
        assertEquals(20 * MS, times.quantileNanos(0.991));
        assertEquals(1.19e6, times.meanNanos(), 1e-6);
    }

    @Test
    void longTimesAreAtMostASixtyFourthTooHigh() {
        SplittableRandom random = new SplittableRandom(1);
        AnswerTimes times = new AnswerTimes();
        long[] all = new long[10_001];
        for (int k = 0; k < all.length; k++) {
            all[k] = random.nextLong(1L << random.nextInt(1, 62));
            times.add(all[k], 2);
        }
        Arrays.sort(all);
        for (double share : new double[] {0.01, 0.1, 0.5, 0.9, 0.99, 0.999}) {
            long exact = all[(int) Math.ceil(share * all.length) - 1];
            long found = times.quantileNanos(share);
            assertTrue(found >= exact && found <= exact + exact / 64.0, share + ": " + exact + " " + found);
        }
        times.add(Long.MAX_VALUE, 3);
        assertEquals(Long.MAX_VALUE, times.quantileNanos(1));
    }

    @Test
    void firstAnswersAreApart() {
        AnswerTimes times = new AnswerTimes();
        assertEquals(Double.NaN, times.meanNanos());
        times.addFirst(300 * MS);
        assertEquals(0, times.count());
        assertEquals(300 * MS, times.worstFirstNanos());
        assertEquals(3e8, times.meanFirstNanos());
    }

    /** Merged in any order: of two equally long ones the earlier game is named. */
    @Test
    void gamesAddUp() {
        AnswerTimes one = new AnswerTimes();
        one.addFirst(10);
        one.add(5, 2);
        one.add(9, 3);
        AnswerTimes other = new AnswerTimes();
        other.addFirst(30);
        other.add(9, 7);
        AnswerTimes both = new AnswerTimes();
        both.addAll(other, 8);
        both.addAll(one, 4);
        assertEquals(3, both.count());
        assertEquals(23.0 / 3, both.meanNanos(), 1e-12);
        assertEquals(9, both.worstNanos());
        assertEquals(4, both.worstGame());
        assertEquals(3, both.worstTurn());
        assertEquals(20, both.meanFirstNanos());
        assertEquals(30, both.worstFirstNanos());
        both.addAll(other, 2);
        assertEquals(2, both.worstGame());
        assertEquals(7, both.worstTurn());
        both.addAll(new AnswerTimes(), 1);
        assertEquals(2, both.worstGame());
    }
}
