package steward.physics.event.cells;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/** A queue of buckets gives out what a search through all events finds, however wide its buckets are. */
@Execution(ExecutionMode.CONCURRENT)
class EventBucketsTest {

    private static final int BODIES = 120;
    private static final double NONE = Double.POSITIVE_INFINITY;

    private static void begin(EventBuckets events, double now, double meanGap) {
        events.begin(BODIES, BODIES, now, meanGap, new int[8 * BODIES + Crowd.PLACE], new double[8 * BODIES + Crowd.X]);
    }

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

    /**
     * The mean gap decides whether all events stand in one bucket, in a few each, or beyond the last one; how many wait
     * long, how often the rest beyond it is looked through, and with how much in it. Whoever comes first waits anew, so
     * that those who wait long are met too; in between others change their minds.
     */
    @ParameterizedTest
    @CsvSource({"1e-9, 20, 1000", "0.01, 20, 1000", "1, 20, 1000", "100, 20, 1000", "1e9, 20, 1000",
        "1, 20, 200", "1, 50, 400", "1, 10, 100"})
    @Tag("sized")
    void theNextEventIsTheEarliest(double meanGap, int oneIn, double far) {
        EventBuckets events = new EventBuckets((i, j) -> i < j);
        SplitMix64 random = new SplitMix64(11);
        for (int turn = 0; turn < 20; turn++) {
            double[] times = new double[BODIES];
            Arrays.fill(times, NONE);
            double now = turn * 10;
            begin(events, now, meanGap);
            for (int step = 0; step < TestSize.of(1500, 5000); step++) {
                int body = first(times);
                assertEquals(body, events.first(), "seed 11, turn " + turn + ", step " + step);
                if (body >= 0) {
                    now = times[body];
                    assertEquals(now, events.time(body));
                }
                if (body < 0 || random.nextInt(8) == 0) {
                    body = random.nextInt(BODIES);
                }
                if (random.nextInt(16) == 0) {
                    events.remove(body);
                    times[body] = NONE;
                } else {
                    // Every third time is a whole number, so that there are ties; some are far away.
                    double wait = (random.nextInt(oneIn) == 0 ? far : 8) * random.nextDouble();
                    times[body] = random.nextInt(3) == 0 ? Math.ceil(now + wait) : now + wait;
                    events.put(body, times[body]);
                }
            }
        }
    }

    /** No body is in the next buckets that is not gathered, and none is gathered that is not there. */
    @Test
    void gatheredAreTheBodiesOfTheNextBuckets() {
        for (int seed = 1; seed <= 50; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            EventBuckets events = new EventBuckets((i, j) -> i < j);
            begin(events, 0, 1);
            for (int body = 0; body < BODIES; body++) {
                events.put(body, 2 * random.nextDouble());
            }
            for (int put = random.nextInt(6000); put > 0; put--) {                // perhaps round the ring
                int body = random.nextInt(3) == 0 ? random.nextInt(BODIES) : events.first();
                events.put(body, events.time(events.first()) + 2 * random.nextDouble());
            }
            for (int body = 0; body < BODIES; body += 7) {
                events.remove(body);
                events.put(Math.min(BODIES - 1, body + 3), 1000);
            }
            events.first();
            int[] gathered = new int[3 * BODIES];
            int ahead = 1 + random.nextInt(20);
            long passed = events.passed();
            Set<Integer> expected = new TreeSet<>();
            Set<Integer> seen = new TreeSet<>();
            int count = events.gatherNext(ahead, gathered, gathered.length - 1);
            Arrays.stream(gathered, 0, count).forEach(seen::add);
            int most = events.gatherNext(BODIES, gathered, 5);
            for (int body = events.first(); body >= 0 && events.passed() <= passed + ahead; body = events.first()) {
                if (events.passed() > passed) {
                    expected.add(body);
                }
                events.remove(body);
            }
            assertEquals(expected, seen, "seed " + seed);
            assertTrue(most <= 5, "seed " + seed + ": " + most);
        }
    }
}
