package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.numerics.SplitMix64;
import steward.scene.Bumper;
import steward.scene.Field;
import steward.scene.SceneFiles;
import steward.scene.json.SceneException;

/**
 * Scenes in which pods start in something, or cannot reach a checkpoint. The map of the scene below, in the box of
 * 16000 x 9000, where two pods of radius 400 start at (4000, 4000), pod 0, and (4000, 5000):
 *
 * <pre>
 *   0,0 +-------------------------------+
 *       |       p
 *       |       0 ---------> 1
 *       |       p            |
 *       |                    2
 * </pre>
 */
@Execution(ExecutionMode.CONCURRENT)
class PlaceCheckTest {

    private static final String SCENE = """
        { "name": "s", "game": "pod-race", "players": 2,
          "field": { "width": 16000, "height": 9000, "walls": "box",
            "bumpers": [ { "x": 9000, "y": 8000, "radius": 9 } ] },
          "pods": { "perPlayer": 1, "radius": 400, "mass": 1 },
          "race": { "laps": 1, "checkpointRadius": 600, "turnsWithoutCheckpoint": 9, "maximumTurns": 9, "maps": [ {
        "checkpoints": [
        { "x": 4000, "y": 4500 },
        { "x": 12000, "y": 4500 },
        { "x": 12000, "y": 7500 } ] } ] },
          "time": { "firstAnswerMs": 1000, "answerMs": 75 },
          "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    private static final String BUMPER = "\"x\": 9000, \"y\": 8000, \"radius\": 9";
    private static final String ROOM = "expected room for 2 pods of radius 400 in a line across this checkpoint, up to "
        + "500 u from it";

    private static List<String> check(String... changes) {
        String text = SCENE;
        for (int k = 0; k < changes.length; k += 2) {
            assertTrue(text.contains(changes[k]), changes[k]);
            text = text.replace(changes[k], changes[k + 1]);
        }
        return TestScenes.TYPES.open(text, "s.json").check();
    }

    private static void refused(String message, String... changes) {
        assertEquals("s.json:" + message, assertThrows(SceneException.class, () -> check(changes)).getMessage());
    }

    @Test
    void aSceneWithRoomHasNoWarnings() {
        assertEquals(List.of(), check());
    }

    @ParameterizedTest
    @ValueSource(strings = {"duel", "mad-pod-racing", "mad-pod-racing-silver", "walled-race"})
    void shippedScenesHaveNone(String name) {
        assertEquals(List.of(), TestScenes.TYPES.open(SceneFiles.load("config/scenes/" + name + ".json").text(), name)
            .check());
    }

    /** Pod 0 is at (4000, 4000), and 500 is contact distance. */
    @Test
    void podsMayTouchABumperButNotStandInIt() {
        assertEquals(List.of(), check(BUMPER, "\"x\": 4000, \"y\": 3500, \"radius\": 100"));
        for (int deep : new int[] {1, 100}) {
            refused("7:1: race.maps[0].checkpoints[0]: found pod 0 at its start " + deep + ".0 u deep in "
                + "field.bumpers[0], " + ROOM, BUMPER, "\"x\": 4000, \"y\": " + (3500 + deep)
                + ", \"radius\": 100");
        }
    }

    /** Sixteen pods stand up to 7500 u from the checkpoint at 1300, in a field of 9000: pod 14 is at -6200. */
    @Test
    void fourPlayersWithFourPodsAreTooManyForABox() {
        refused("7:1: race.maps[0].checkpoints[0]: found pod 14 at its start 6600.0 u deep in the top wall, "
            + "expected room for 16 pods of radius 400 in a line across this checkpoint, up to 7500 u from it",
            "\"players\": 2", "\"players\": 4", "\"perPlayer\": 1", "\"perPlayer\": 4",
            "\"x\": 4000, \"y\": 4500", "\"x\": 4000, \"y\": 1300", "\"x\": 12000, \"y\": 4500",
            "\"x\": 12000, \"y\": 1300");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        [ { "type": "half-plane", "x": 0, "y": 3700, "insideX": 0, "insideY": 1 } ] | pod 0 at its start 100.0 u deep
        [ { "type": "segment", "ax": 3000, "ay": 4900, "bx": 6000, "by": 4900 } ]   | pod 1 at its start 300.0 u deep
        [ { "type": "arena", "x": 4000, "y": 4500, "radius": 800 } ]                | pod 0 at its start 100.0 u deep
        """)
    void everyKindOfWallCounts(String walls, String where) {
        String message = assertThrows(SceneException.class, () -> check("\"box\"", walls)).getMessage();
        assertTrue(message.contains(where + " in field.walls[0]"), message);
    }

    @Test
    void withoutWallsTheFieldStillHasAnEdge() {
        refused("7:1: race.maps[0].checkpoints[0]: found pod 0 at its start 400.0 u outside the edge of the field, "
            + ROOM,
            "\"box\"", "[]", "\"x\": 4000, \"y\": 4500", "\"x\": 4000, \"y\": 100",
            "\"x\": 12000, \"y\": 4500", "\"x\": 12000, \"y\": 100");
    }

    /** From checkpoint 1 towards 2 pods stand at (12500, 4500) and (11500, 4500), from 2 towards 0 elsewhere. */
    @Test
    void everyShiftIsLookedAt() {
        String[] bumper = {BUMPER, "\"x\": 12500, \"y\": 5000, \"radius\": 200"};
        assertEquals(List.of(), check(bumper));
        refused("8:1: race.maps[0].checkpoints[1]: found pod 0 at its start 100.0 u deep in field.bumpers[0] "
            + "(shifted: races may start here), " + ROOM,
            bumper[0], bumper[1], "\"laps\": 1", "\"laps\": 1, \"shift\": true");
    }

    /** A gap of 20 at a bumper right above pod 0 is closed by a jitter of 30 upwards, not by one of 10. */
    @Test
    void jitterIsTakenAtItsWorst() {
        String[] bumper = {BUMPER, "\"x\": 4000, \"y\": 3480, \"radius\": 100"};
        assertEquals(List.of(), check(bumper));
        assertEquals(List.of(), check(bumper[0], bumper[1], "\"laps\": 1", "\"laps\": 1, \"jitter\": 10"));
        String message = assertThrows(SceneException.class,
            () -> check(bumper[0], bumper[1], "\"laps\": 1", "\"laps\": 1, \"jitter\": 30")).getMessage();
        assertTrue(message.startsWith("s.json:7:1: race.maps[0].checkpoints[0]: found pod 0 at its start "), message);
        assertTrue(message.contains("with jitter that puts it at (40") || message.contains("at (39"), message);
    }

    @Test
    void checkpointsThatCanBeInOnePlaceGivePodsNoDirection() {
        refused("9:1: race.maps[0].checkpoints[2]: found a checkpoint in one place with the next one (shifted: races "
            + "may start here), expected two places at every draw: pods start across them",
            "\"x\": 12000, \"y\": 7500", "\"x\": 4000, \"y\": 4500", "\"laps\": 1", "\"laps\": 1, \"shift\": true");
        refused("7:1: race.maps[0].checkpoints[0]: found a checkpoint in one place with the next one at some jitter, "
            + "expected two places at every draw: pods start across them",
            "\"x\": 12000, \"y\": 4500", "\"x\": 4060, \"y\": 4440", "\"laps\": 1", "\"laps\": 1, \"jitter\": 30");
    }

    @Test
    void podsThatStartInEachOtherAreTooLarge() {
        assertEquals(List.of(), check("\"radius\": 400", "\"radius\": 500"));
        refused("4:39: pods.radius: found 501, expected at most 500: pods start 1000 u apart",
            "\"radius\": 400", "\"radius\": 501");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        "x": 12000, "y": 9199 |
        "x": 12000, "y": 9201 | the bottom wall
        "x": -500, "y": 4500  | the left wall
        """)
    void aCheckpointBehindAWallIsAWarning(String place, String barrier) {
        assertEquals(barrier == null ? List.of() : List.of("s.json:9:1: race.maps[0].checkpoints[2]: found a "
            + "checkpoint that no pod can reach: what counts is behind or under " + barrier
            + ", expected a place nearer than 600 u to where pods can be"), check("\"x\": 12000, \"y\": 7500", place));
    }

    /** A bumper of 700 keeps pods 1100 away from its centre: a checkpoint of 600 is covered if nearer than 500. */
    @Test
    void aCheckpointUnderABumperIsAWarning() {
        String[] bumper = {BUMPER, "\"x\": 12499, \"y\": 7500, \"radius\": 700"};
        assertEquals(1, check(bumper).size());
        assertEquals(List.of(), check(bumper[0], bumper[1].replace("12499", "12501")));
        assertEquals(1, check(bumper[0], bumper[1].replace("12499", "12501"), "\"laps\": 1",
            "\"laps\": 1, \"jitter\": 2").size());
    }

    @Test
    void manyWarningsAreCounted() {
        List<String> warnings = check("{ \"x\": 12000, \"y\": 7500 }", "{ \"x\": 12000, \"y\": 7500 }"
            + ", { \"x\": -900, \"y\": 1 }".repeat(12));
        assertEquals(11, warnings.size());
        assertEquals("s.json: found 2 more checkpoints that no pod can reach", warnings.get(10));
    }

    /** Random fields: what the check finds overlaps, and where it finds nothing, no draw of many does. */
    @Test
    @Tag("slow")
    void itAgreesWithWhatIsDrawn() {
        SplitMix64 random = new SplitMix64(20);
        int[] verdicts = new int[2];
        for (int round = 0; round < 300; round++) {
            String text = SCENE.replace("\"players\": 2", "\"players\": " + (1 + random.nextInt(4)))
                .replace("\"laps\": 1", "\"laps\": 1, \"jitter\": " + random.nextInt(120) + ", \"shift\": "
                    + (random.nextInt(2) == 0))
                .replace("\"x\": 9000, \"y\": 8000, \"radius\": 9", "\"x\": " + random.nextInt(16_000) + ", \"y\": "
                    + random.nextInt(9000) + ", \"radius\": " + (1 + random.nextInt(900)))
                .replace("\"x\": 4000, \"y\": 4500", "\"x\": " + (2000 + random.nextInt(9000)) + ", \"y\": "
                    + (2000 + random.nextInt(5000)));
            GameSetup setup = TestScenes.TYPES.open(text, "s.json");
            String found = null;
            try {
                setup.check();
            } catch (SceneException refusal) {
                found = refusal.getMessage();
            }
            List<Double> depths = new ArrayList<>();
            for (long seed = 0; seed < 200; seed++) {
                depths.add(depth((PodRace) setup.create(seed), setup.scene().field().get()));
            }
            double deepest = depths.stream().mapToDouble(depth -> depth).max().getAsDouble();
            assertTrue(found != null || deepest < 1, found + ", but " + deepest + " in " + text);
            verdicts[found == null ? 0 : 1]++;
        }
        assertTrue(verdicts[0] > 30 && verdicts[1] > 30, "both verdicts: " + verdicts[0] + ", " + verdicts[1]);
    }

    private static double depth(PodRace race, Field field) {
        double depth = Double.NEGATIVE_INFINITY;
        for (int pod = 0; pod < race.settings().pods(); pod++) {
            double x = race.pod(pod).x();
            double y = race.pod(pod).y();
            for (Bumper bumper : field.bumpers()) {
                depth = Math.max(depth, bumper.radius() + 400 - Math.hypot(x - bumper.x(), y - bumper.y()));
            }
            depth = Math.max(depth, field.walls().stream().mapToDouble(wall -> -wall.gap(x, y, 400)).max()
                .getAsDouble());
        }
        return depth;
    }
}
