package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/**
 * Checkpoints that walls and bumpers shut in, so that no pod comes to them from its start, in the map:
 *
 * <pre>
 *   0,0 +-------------------------------+ 16000
 *       |       p
 *       |       0 ---------> 1           pods of radius 400 start at (4000, 4000) and (4000, 5000);
 *       |       p            |           checkpoints of radius 600 at (4000, 4500), (12000, 4500) and (12000, 7500)
 *       |                    2
 * </pre>
 */
@Execution(ExecutionMode.CONCURRENT)
class ShutInTest {

    private static final String SCENE = """
        { "name": "s", "game": "pod-race", "players": 2,
          "field": { "width": 16000, "height": 9000, "walls": WALLS, "bumpers": [ BUMPERS ] },
          "pods": { "perPlayer": 1, "radius": 400, "mass": 1 },
          "race": { "laps": 1, "checkpointRadius": 600, "turnsWithoutCheckpoint": 9, "maximumTurns": 9, "maps": [ {
        "checkpoints": [
        { "x": 4000, "y": 4500 },
        { "x": 12000, "y": 4500 },
        { "x": 12000, "y": 7500 } ] } ] },
          "time": { "firstAnswerMs": 1000, "answerMs": 75 },
          "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;
    private static final int FIRST_LINE = 6;
    private static final String LAPS = "\"laps\": 1";

    private static final int GRID = 50;
    /** The four walls of the box, so that there can be others. */
    private static final List<String> BOX = List.of(halfPlane(0, 0, 1, 0), halfPlane(0, 0, 0, 1),
        halfPlane(16_000, 0, -1, 0), halfPlane(0, 9000, 0, -1));

    private static String halfPlane(int x, int y, int insideX, int insideY) {
        return String.format(Locale.ROOT, "{ \"type\": \"half-plane\", \"x\": %d, \"y\": %d, \"insideX\": %d, "
            + "\"insideY\": %d }", x, y, insideX, insideY);
    }

    private static String segment(double ax, double ay, double bx, double by) {
        return String.format(Locale.ROOT, "{ \"type\": \"segment\", \"ax\": %.3f, \"ay\": %.3f, \"bx\": %.3f, "
            + "\"by\": %.3f }", ax, ay, bx, by);
    }

    private static String scene(String walls, String bumpers) {
        return SCENE.replace("WALLS", walls).replace("BUMPERS", bumpers);
    }

    private static List<String> check(String text) {
        return TestScenes.TYPES.open(text, "s.json").check();
    }

    /** The checkpoints warned of; the first is on line {@value #FIRST_LINE}. */
    private static List<Integer> warned(String text) {
        return check(text).stream().map(warning -> Integer.parseInt(warning.split(":")[1]) - FIRST_LINE).toList();
    }

    /** Bumpers on a circle, each at the same distance from the next. */
    private static String ring(double x, double y, double radius, int bumpers, double bumper) {
        List<String> ring = new ArrayList<>();
        for (int k = 0; k < bumpers; k++) {
            double angle = 2 * Math.PI * k / bumpers;
            ring.add(bumper(x + radius * StrictMath.cos(angle), y + radius * StrictMath.sin(angle), bumper));
        }
        return String.join(", ", ring);
    }

    private static String bumper(double x, double y, double radius) {
        return String.format(Locale.ROOT, "{ \"x\": %.3f, \"y\": %.3f, \"radius\": %.3f }", x, y, radius);
    }

    /** Twelve bumpers around checkpoint 1, 1035 apart: a pod of 800 goes between those of radius 100. */
    @Test
    void aRingOfBumpersShutsACheckpointIn() {
        assertEquals(List.of("s.json:7:1: race.maps[0].checkpoints[1]: found a checkpoint that no pod can reach from "
            + "a start at checkpoint 0: walls and bumpers shut it in or the start, expected a gap at least 800 u "
            + "wide, for pods of radius 400"), check(scene("\"box\"", ring(12_000, 4500, 2000, 12, 200))));
        assertEquals(List.of(), check(scene("\"box\"", ring(12_000, 4500, 2000, 12, 100))));
    }

    /** Of twelve bumpers on a circle of 2000 the centres are 2 * 2000 * sin(15 degrees) = 1035.28 apart. */
    @ParameterizedTest
    @CsvSource({"117.5, 0", "118.0, 0", "120.0, 1", "125.0, 1"})
    void aGapOfAPodIsAWay(double bumper, int warnings) {
        assertEquals(warnings, check(scene("\"box\"", ring(12_000, 4500, 2000, 12, bumper))).size());
    }

    /** A pod outside the ring comes near enough: the ring of 900 keeps it 1300 away at most, the checkpoint is 600. */
    @Test
    void aCheckpointThatReachesThroughTheRingIsReached() {
        String ring = ring(12_000, 4500, 900, 8, 50);
        assertEquals(List.of(1), warned(scene("\"box\"", ring)));
        assertEquals(List.of(), warned(scene("\"box\"", ring).replace("600", "1400")));
    }

    /** One bumper of the ring is missing. */
    @Test
    void anOpenRingIsAWay() {
        String ring = ring(12_000, 4500, 2000, 12, 200);
        assertEquals(List.of(), check(scene("\"box\"", ring.substring(ring.indexOf("},") + 2))));
    }

    @Test
    void podsInARingReachNothingElse() {
        assertEquals(List.of(1, 2), warned(scene("\"box\"", ring(4000, 4500, 2000, 12, 200))));
    }

    @Test
    void ringsInRingsPartAsWell() {
        assertEquals(List.of(1), warned(scene("[]", ring(12_000, 4500, 1500, 12, 200) + ", "
            + ring(12_000, 4500, 2200, 16, 200))));
    }

    /** From checkpoint 1 the pods start at (12500, 4500) and (11500, 4500), in the ring with it. */
    @Test
    void everyShiftIsLookedAt() {
        String ring = scene("\"box\"", ring(12_000, 4500, 2000, 12, 200)).replace(LAPS, LAPS + ", \"shift\": true")
            .replace("\"x\": 12000, \"y\": 7500", "\"x\": 4000, \"y\": 8000");
        assertEquals(List.of(0, 1, 2), warned(ring));
        assertTrue(check(ring).get(0).contains("a start at checkpoint 1 (shifted: races may start there)"),
            check(ring).get(0));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        across the box             | 8000 0 8000 9000                                           | 1 2
        with a gap at the end      | 8000 0 8000 8100                                           |
        too narrow at the end      | 8000 0 8000 8300                                           | 1 2
        two in a row, and a gap    | 8000 0 8000 4000, 8000 4900 8000 9000                      |
        two in a row               | 8000 0 8000 4000, 8000 4700 8000 9000                      | 1 2
        a cross                    | 8000 0 8000 9000, 8000 6000 16000 6000                     | 1 2
        a cross with a way in      | 8000 6000 8000 9000, 8000 6000 15000 6000                  |
        a triangle                 | 12000 2000 9000 6000, 9000 6000 15000 6000, 15000 6000 12000 2000 | 1
        """)
    void segmentsPart(String title, String ends, String expected) {
        List<String> walls = new ArrayList<>(BOX);
        for (String segment : ends.split(",")) {
            double[] at = Arrays.stream(segment.trim().split(" ")).mapToDouble(Double::parseDouble).toArray();
            walls.add(segment(at[0], at[1], at[2], at[3]));
        }
        List<Integer> checkpoints = expected == null ? List.of()
            : List.of(expected.split(" ")).stream().map(Integer::parseInt).toList();
        assertEquals(checkpoints, warned(scene(walls.toString(), "")), title);
    }

    /** A strip between two endless walls, open at both ends, 7000 wide, with a bumper across it. */
    @Test
    void aBumperClosesAStrip() {
        String strip = List.of(halfPlane(0, 1000, 0, 1), halfPlane(0, 8000, 0, -1)).toString();
        assertEquals(List.of(1, 2), warned(scene(strip, bumper(8000, 4500, 2800))));
        assertEquals(List.of(), warned(scene(strip, bumper(8000, 4500, 2600))));
    }

    /** In an arena around (8000, 4500) a wall from edge to edge parts, and one that ends 1000 before it does not. */
    @Test
    void aWallAcrossAnArena() {
        String arena = "[ { \"type\": \"arena\", \"x\": 8000, \"y\": 4500, \"radius\": 6000 }, "
            + segment(8000, -1500, 8000, 10_500) + " ]";
        assertEquals(List.of(1, 2), warned(scene(arena, "")));
        assertEquals(List.of(), warned(scene(arena.replace("10500", "9500"), "")));
    }

    /** Between fixed steps a pod may pass through a wall. */
    @Test
    void stepsAreNotSure() {
        String ring = scene("\"box\"", ring(12_000, 4500, 2000, 12, 200));
        assertEquals(List.of(), check(ring.replace("\"advance\": \"event\", \"arithmetic\": \"double\"",
            "\"advance\": \"step\", \"steps\": 4")));
    }

    /** With a jitter of 1000 a checkpoint can be 1414 away, where what counts is partly outside the ring. */
    @Test
    void itIsCertainAtEveryJitter() {
        String ring = scene("\"box\"", ring(12_000, 4500, 2000, 12, 125));
        assertEquals(List.of(1), warned(ring.replace(LAPS, LAPS + ", \"jitter\": 100")));
        assertEquals(List.of(), warned(ring.replace(LAPS, LAPS + ", \"jitter\": 1000")));
    }

    @Test
    @Tag("sized")
    @Tag("slow")
    void itAgreesWithAWalk() {
        agreesWithAWalk(TestSize.of(3, 120), 1);
    }

    /**
     * Random bumpers and segments: where a walk on a grid of 50 u comes to a checkpoint there is no warning; where it
     * does not either, although obstacles are smaller by 50 u more than positions are rounded, there is one.
     */
    private static void agreesWithAWalk(int rounds, long seed) {
        SplitMix64 random = new SplitMix64(seed);
        int[] verdicts = new int[2];
        for (int round = 0; round < rounds; round++) {
            List<double[]> obstacles = new ArrayList<>();
            List<String> bumpers = new ArrayList<>();
            List<String> walls = new ArrayList<>(BOX);
            for (int k = 35 + random.nextInt(50); k > 0; k--) {
                double x = random.nextInt(16_000);
                double y = random.nextInt(9000);
                boolean segment = random.nextInt(3) == 0;
                double[] obstacle = segment ? new double[] {x, y, x + random.nextInt(-2000, 2000), y + 1, 0}
                    : new double[] {x, y, x, y, 1 + random.nextInt(700)};
                if (!outside(List.of(obstacle), 401, 4000, 4000) || !outside(List.of(obstacle), 401, 4000, 5000)) {
                    continue;
                }
                obstacles.add(obstacle);
                if (segment) {
                    walls.add(segment(x, y, obstacle[2], obstacle[3]));
                } else {
                    bumpers.add(bumper(x, y, obstacle[4]));
                }
            }
            String text = scene(walls.toString(), String.join(", ", bumpers));
            List<Integer> found = warned(text);
            boolean[] reached = walk(obstacles, 400, 600);
            boolean[] nearly = walk(obstacles, 400 - 52, 652);
            for (int k = 0; k < 3; k++) {
                boolean warned = found.contains(k);
                assertTrue(!(warned && reached[k]), "checkpoint " + k + " is reached in round " + round + ": " + text);
                assertTrue(warned || nearly[k], "checkpoint " + k + " is shut in in round " + round + ": " + text);
                verdicts[warned ? 1 : 0]++;
            }
        }
        assertTrue(Math.min(verdicts[0], verdicts[1]) > rounds / 6,
            "both verdicts: " + verdicts[0] + ", " + verdicts[1]);
    }

    /** A thousand bumpers in each other and 901 maps with a warning each: after the steps allowed there are no more. */
    @Test
    @Tag("slow")
    void whereThereIsTooMuchToLookAtThereIsNoWarning() {
        List<String> bumpers = new ArrayList<>();
        for (int k = 0; k < 1000; k++) {
            bumpers.add(bumper(8000 + k % 40 * 180, 200 + k / 40 * 300, 150));
        }
        String map = SCENE.substring(SCENE.indexOf("{\n\"checkpoints\""), SCENE.indexOf("] },\n  \"time\""));
        String text = scene("\"box\"", String.join(", ", bumpers));
        assertEquals(List.of(1), warned(text));
        List<String> many = check(text.replace(map, map + (", " + map).repeat(900)));
        assertEquals("s.json: found ", many.get(10).substring(0, 14));
        assertTrue(Integer.parseInt(many.get(10).split(" ")[2]) < 400, many.get(10));
    }

    /** Which checkpoints a circle comes to in steps of 50 u from the two starts. */
    private static boolean[] walk(List<double[]> obstacles, double radius, double counts) {
        int columns = 16_000 / GRID + 1;
        int rows = 9000 / GRID + 1;
        boolean[] seen = new boolean[columns * rows];
        ArrayDeque<Integer> edge = new ArrayDeque<>(List.of(4000 / GRID + 4000 / GRID * columns,
            4000 / GRID + 5000 / GRID * columns));
        edge.forEach(cell -> seen[cell] = true);
        boolean[] reached = new boolean[3];
        double[][] checkpoints = {{4000, 4500}, {12_000, 4500}, {12_000, 7500}};
        while (!edge.isEmpty()) {
            int cell = edge.remove();
            double x = cell % columns * GRID;
            double y = cell / columns * GRID;
            for (int k = 0; k < 3; k++) {
                reached[k] |= Math.hypot(x - checkpoints[k][0], y - checkpoints[k][1]) <= counts;
            }
            for (int[] move : new int[][] {{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                int next = cell + move[0] + move[1] * columns;
                double nextX = x + GRID * move[0];
                double nextY = y + GRID * move[1];
                boolean inBox = nextX >= radius && nextX <= 16_000 - radius && nextY >= radius
                    && nextY <= 9000 - radius;
                if (inBox && !seen[next] && outside(obstacles, radius, nextX, nextY)
                    && outside(obstacles, radius, (x + nextX) / 2, (y + nextY) / 2)) {
                    seen[next] = true;
                    edge.add(next);
                }
            }
        }
        return reached;
    }

    /** Obstacles are all places up to a radius from a segment: {@code {ax, ay, bx, by, radius}}. */
    private static boolean outside(List<double[]> obstacles, double radius, double x, double y) {
        for (double[] at : obstacles) {
            double dx = at[2] - at[0];
            double dy = at[3] - at[1];
            double square = dx * dx + dy * dy;
            double share = square == 0 ? 0
                : Math.max(0, Math.min(1, ((x - at[0]) * dx + (y - at[1]) * dy) / square));
            double apartX = x - at[0] - share * dx;
            double apartY = y - at[1] - share * dy;
            if (apartX * apartX + apartY * apartY <= (at[4] + radius) * (at[4] + radius)) {
                return false;
            }
        }
        return true;
    }
}
