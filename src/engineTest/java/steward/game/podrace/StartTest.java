package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.podrace.protocol.PodRaceType;
import steward.numerics.SplitMix64;

/** State before the first turn: the map drawn by lot, and the pods across checkpoint 0. */
@Execution(ExecutionMode.CONCURRENT)
class StartTest {

    /** The 13 official maps as the issue that asked for them lists them. */
    private static final String[] MAPS = {
        "12460 1350 10540 5980 3580 5180 13580 7600",
        "3600 5280 13840 5080 10680 2280 8700 7460 7200 2160",
        "4560 2180 7350 4940 3320 7230 14580 7700 10560 5060 13100 2320",
        "5010 5260 11480 6080 9100 1840",
        "14660 1410 3450 7220 9420 7240 5970 4240",
        "3640 4420 8000 7900 13300 5540 9560 1400",
        "4100 7420 13500 2340 12940 7220 5640 2580",
        "14520 7780 6320 4290 7800 860 7660 5970 3140 7540 9520 4380",
        "10040 5970 13920 1940 8020 3260 2670 7020",
        "7500 6940 6000 5360 11300 2820",
        "4060 4660 13040 1900 6560 7840 7480 1360 12700 7100",
        "3020 5190 6280 7760 14100 7760 13880 1220 10240 4920 6100 2200",
        "10323 3366 11203 5425 7259 6656 5425 2838"};

    private static double[] map(int number) {
        return Arrays.stream(MAPS[number].split(" ")).mapToDouble(Double::parseDouble).toArray();
    }

    /** Draws: the map, the first checkpoint, then for each checkpoint in the new order x and y. */
    private static double[][] drawn(long seed, Set<String> seen) {
        SplitMix64 random = new SplitMix64(seed);
        int number = random.nextInt(13);
        double[] map = map(number);
        int count = map.length / 2;
        int first = random.nextInt(count);
        double[][] drawn = new double[count][2];
        for (int k = 0; k < count; k++) {
            for (int axis = 0; axis < 2; axis++) {
                int jitter = random.nextInt(61) - 30;
                drawn[k][axis] = map[2 * ((first + k) % count) + axis] + jitter;
                seen.add("jitter " + jitter);
            }
        }
        seen.add("map " + number + " from " + first);
        return drawn;
    }

    @Test
    void theMapFollowsFromTheSeedByTheDocumentedDraws() {
        PodRaceType.PodRaceSetup official = Races.setup("mad-pod-racing");
        Set<String> seen = new TreeSet<>();
        IntStream.range(-1000, 1000).mapToLong(k -> k * 0x9E3779B97F4A7C1L).forEach(seed ->
            assertArrayEquals(drawn(seed, seen), official.create(seed).checkpoints(), () -> "seed " + seed));

        int starts = Arrays.stream(MAPS).mapToInt(map -> map.split(" ").length / 2).sum();
        assertEquals(starts + 61, seen.size(), "every map from every checkpoint, and every jitter -30..30");
    }

    @Test
    void aSceneWithoutShiftAndJitterDrawsOnlyItsMap() {
        for (long seed = 0; seed < 20; seed++) {
            assertArrayEquals(new double[][] {{5500, 3000}, {10500, 3500}, {7500, 6300}},
                Races.setup("duel").create(seed).checkpoints());
        }
    }

    @Test
    void aSceneWithJitterAloneDrawsTheMapAndThenTheJitter() {
        for (long seed = 0; seed < 50; seed++) {
            PodRaceType.PodRaceSetup walled = Races.setup("walled-race");
            SplitMix64 random = new SplitMix64(seed);
            double[][] map = walled.settings().maps().get(random.nextInt(13));
            double[][] expected = new double[map.length][2];
            for (int k = 0; k < map.length; k++) {
                expected[k][0] = map[k][0] + random.nextInt(61) - 30;
                expected[k][1] = map[k][1] + random.nextInt(61) - 30;
            }
            assertArrayEquals(expected, walled.create(seed).checkpoints());
        }
    }

    /**
     * From checkpoint 0 at (1000, 2000) towards 1 at (1600, 2800) the direction is (0.6, 0.8); across it is
     * (-0.8, 0.6), and pods stand at -500, 500, -1500 and 1500 of it.
     */
    @Test
    void podsStandAcrossTheFirstCheckpoint() {
        PodRace race = Races.setup("mad-pod-racing").create(new double[][] {{1000, 2000}, {1600, 2800}});

        double[][] places = {{1400, 1700}, {600, 2300}, {2200, 1100}, {-200, 2900}};
        for (int pod = 0; pod < 4; pod++) {
            assertEquals(new PodState(places[pod][0], places[pod][1], 0, 0, Double.NaN, 0, true, 0), race.pod(pod));
            assertEquals(pod / 2, race.playerOf(pod));
            assertEquals(1, race.nextCheckpoint(pod));
            assertEquals(0, race.lap(pod));
        }
        assertEquals(100, race.turnsLeft(0));
    }

    /** Towards (1, 0) the pods stand at y = 0.5 -+ 500: halves go up, also below 0. */
    @Test
    void startPlacesAreRoundedWithHalvesUp() {
        PodRace race = Races.setup("mad-pod-racing").create(new double[][] {{0.5, 0.5}, {100.5, 0.5}});

        assertEquals(1, race.pod(0).x());
        assertEquals(-499, race.pod(0).y());
        assertEquals(501, race.pod(1).y());
        assertEquals(-1499, race.pod(2).y());
    }

    @Test
    void furtherPodsStandFurtherOut() {
        PodRace race = Races.duel(6, new double[][] {{0, 0}, {1000, 0}});

        for (int pod = 0; pod < 6; pod++) {
            assertEquals(new double[] {-500, 500, -1500, 1500, -2500, 2500}[pod], race.pod(pod).y());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "walled-race", "duel"})
    void nobodyTouchesAnybodyAtTheStart(String scene) {
        for (long seed = 0; seed < 300; seed++) {
            PodRace race = Races.setup(scene).create(seed);
            for (int a = 0; a < race.settings().pods(); a++) {
                for (int b = 0; b < race.bodies().size(); b++) {
                    double distance = Math.hypot(race.bodies().x[a] - race.bodies().x[b],
                        race.bodies().y[a] - race.bodies().y[b]);
                    double touch = race.bodies().radius[a] + race.bodies().radius[b];
                    assertTrue(a == b || distance > touch, "seed " + seed + ", " + a + " and " + b);
                }
            }
        }
    }
}
