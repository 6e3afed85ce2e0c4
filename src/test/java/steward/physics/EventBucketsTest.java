package steward.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.numerics.SplitMix64;

/** A queue of buckets gives out what a search through all events finds, however wide its buckets are. */
class EventBucketsTest {

    private static final int BODIES = 120;
    private static final double NONE = Double.POSITIVE_INFINITY;

    /** By time, ties by number. */
    private static int first(double[] times) {
        int first = -1;
        for (int body = 0; body < times.length; body++) {
            if (times[body] < (first < 0 ? NONE : times[first])) {
                first = body;
            }
        }
        return first;
    }

    /** The mean gap decides whether all events stand in one bucket, in a few each, or beyond the last one. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 0.01, 1, 100, 1e9})
    void theNextEventIsTheEarliest(double meanGap) {
        EventBuckets events = new EventBuckets((i, j) -> i < j);
        SplitMix64 random = new SplitMix64(11);
        for (int turn = 0; turn < 20; turn++) {
            double[] times = new double[BODIES];
            Arrays.fill(times, NONE);
            double now = turn * 10;
            events.begin(BODIES, BODIES, now, meanGap);
            for (int step = 0; step < 3000; step++) {
                int body = random.nextInt(BODIES);
                if (random.nextInt(4) == 0) {
                    events.remove(body);
                    times[body] = NONE;
                } else {
                    // Every third time is a whole number, so that there are ties; some are far away.
                    double wait = (random.nextInt(20) == 0 ? 1000 : 8) * random.nextDouble();
                    times[body] = random.nextInt(3) == 0 ? Math.ceil(now + wait) : now + wait;
                    events.put(body, times[body]);
                }
                if (random.nextInt(2) == 0) {
                    int expected = first(times);
                    assertEquals(expected, events.first(), "seed 11, turn " + turn + ", step " + step);
                    if (expected >= 0) {
                        now = times[expected];
                        assertEquals(now, events.time(expected));
                    }
                    if (expected >= 0 && random.nextInt(3) > 0) {
                        events.remove(expected);
                        times[expected] = NONE;
                    }
                }
            }
        }
    }
}
