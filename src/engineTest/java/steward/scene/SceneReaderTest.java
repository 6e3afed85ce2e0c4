package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.ImpactLaw.ScanOrder;
import steward.physics.Motion;
import steward.physics.Segment;
import steward.physics.Wall;
import steward.scene.json.SceneException;

/** Values that the common part of a scene file becomes. */
class SceneReaderTest {

    private static final String REQUIRED = """
        "name": "s", "game": "g", "players": 3, "time": { "firstAnswerMs": 1000, "answerMs": 75 },
        "accuracy": { "advance": "event", "arithmetic": "official" }""";

    /** Flags of a scene: velocities and places become whole numbers at the end of a turn, or not. */
    private static List<Boolean> roundings(Scene scene) {
        return List.of(scene.motion().step(Motion.Of.VELOCITY) != null,
            scene.motion().step(Motion.Of.POSITION) != null);
    }

    @Test
    void whatIsAbsentIsPlainPhysics() {
        Scene scene = scene("");
        assertEquals("s", scene.name());
        assertEquals("g", scene.gameId());
        assertEquals(3, scene.players());
        assertEquals(Optional.empty(), scene.field());
        assertEquals(ImpactLaw.PHYSICS, scene.law());
        assertEquals(ImpactLaw.PHYSICS, scene(", \"impacts\": {}").law());
        assertEquals(0, scene.drag());
        assertEquals(List.of(false, false), roundings(scene));
        assertEquals(new Time(1000, 75), scene.time());
        assertEquals(Accuracy.event(Arithmetic.OFFICIAL), scene.accuracy());
    }

    @Test
    void everyFieldOfImpactsReachesTheLaw() {
        assertEquals(new ImpactLaw(Restitution.ELASTIC, 30, true, 1, true, 0.5, ScanOrder.DESCENDING, 2, 7), scene("""
            , "impacts": { "minimumImpulse": 30, "minimumImpulseAtWalls": true, "deadZone": 1, "batchWindow": 0.5,
              "separatingPairs": "react", "scanOrder": "descending", "pushOut": 2, "maximumImpactsPerTurn": 7 }
            """).law());
        assertEquals(ImpactLaw.PHYSICS, scene("""
            , "impacts": { "separatingPairs": "ignore", "scanOrder": "ascending" }""").law());
    }

    @Test
    void motionIsReadFieldByField() {
        Scene scene = scene(", \"motion\": { \"drag\": 0.15, \"position\": \"round\" }");
        assertEquals(0.15, scene.drag());
        assertEquals(List.of(false, true), roundings(scene));
    }

    @Test
    void motionHasOtherRoundingsAndAnotherOrder() {
        assertEquals(new Motion(List.of(Motion.Step.ROUND_POSITION_AWAY, Motion.Step.DRAG, Motion.Step.ROUND_VELOCITY)),
            scene(", \"motion\": { \"drag\": 0.2, \"velocity\": \"round-half-away\", "
                + "\"position\": \"round-half-away\", \"first\": \"position\" }").motion());
        assertEquals(new Motion(List.of(Motion.Step.SNAP_VELOCITY, Motion.Step.SNAP_POSITION)),
            scene(", \"motion\": { \"velocity\": \"truncate-snap\", \"position\": \"truncate-snap\" }").motion());
    }

    /** A centred world: the field begins at (-10, -5). */
    @Test
    void aFieldMayHaveItsOriginElsewhere() {
        Field field = scene(", \"field\": { \"x\": -10, \"y\": -5, \"width\": 20, \"height\": 10, "
            + "\"walls\": \"box\" }").field().get();
        assertEquals(new Field(-10, -5, 20, 10, List.of(Wall.box(-10, -5, 20, 10, 1)), List.of()), field);
        assertEquals(3, field.walls().get(2).gap(6, 0, 1), "right, at x = 10");
        assertEquals(2, field.walls().get(1).gap(0, -2, 1), "top, at y = -5");
    }

    @Test
    void aBoxIsFourWalls() {
        assertEquals(List.of(Wall.box(20, 10, 1)), field("\"box\"").walls());
        assertEquals(List.of(Wall.box(20, 10, 0.9)), field("{ \"type\": \"box\", \"restitution\": 0.9 }").walls());
    }

    @Test
    void singleWallsMixInTheOrderOfTheFile() {
        assertEquals(List.of(new Arena(1, 2, 3, 1), new Segment(1, 2, 3, 4, 0.5), new HalfPlane(0, 0, 0.6, 0.8, 1)),
            field("""
                [ { "type": "arena", "x": 1, "y": 2, "radius": 3 },
                  { "type": "segment", "ax": 1, "ay": 2, "bx": 3, "by": 4, "restitution": 0.5 },
                  { "type": "half-plane", "x": 0, "y": 0, "insideX": 0.6, "insideY": 0.8 } ]""").walls());
    }

    @Test
    void aFieldMayHaveNeitherWallsNorBumpers() {
        Field field = scene(", \"field\": { \"width\": 20, \"height\": 10 }").field().get();
        assertEquals(new Field(20, 10, List.of(), List.of()), field);
    }

    @Test
    void bumpersGiveBackAllUnlessStated() {
        assertEquals(List.of(new Bumper(1, 2, 3, 1), new Bumper(4, -5, 6, 0.5)), scene("""
            , "field": { "width": 20, "height": 10, "bumpers": [
              { "x": 1, "y": 2, "radius": 3 }, { "x": 4, "y": -5, "radius": 6, "restitution": 0.5 } ] }
            """).field().get().bumpers());
    }

    @Test
    void theJsonOfASceneIsOneLineInTheSameOrderAndWords() {
        String json = scene("""
            , "z": { "b": 1e-5, "a": [ 1.0, -0, 1E+2, 0.10, true, null, [], {} ] }, "y": "é \\" \\\\ \\n \\u2028\"""")
            .json();
        assertEquals("{\"name\":\"s\",\"game\":\"g\",\"players\":3,\"time\":{\"firstAnswerMs\":1000,\"answerMs\":75},"
            + "\"accuracy\":{\"advance\":\"event\",\"arithmetic\":\"official\"},\"z\":{\"b\":1e-5,"
            + "\"a\":[1.0,-0,1E+2,0.10,true,null,[],{}]},\"y\":\"\\u00E9 \\\" \\\\ \\n \\u2028\"}", json);
        assertEquals(json, SceneReader.read(json, "again").json());
    }

    @Test
    void evenHalfACharacterSurvives() {
        String json = scene(", \"y\": \"\\ud800\"").json();
        assertEquals("\\ud800", json.substring(json.length() - 8, json.length() - 2).toLowerCase(Locale.ROOT));
        assertEquals(json, SceneReader.read(json, "again").json());
    }

    @Test
    void aSceneReadAgainIsEqualAndAnotherIsNot() {
        Scene scene = scene(", \"impacts\": { \"minimumImpulse\": 120 }");
        Scene again = SceneReader.read(scene.json(), "again");
        assertEquals(scene, again);
        assertEquals(scene.hashCode(), again.hashCode());
        assertNotEquals(scene, scene(", \"impacts\": { \"minimumImpulse\": 121 }"));
    }

    @Test
    void theBlocksOfTheGameAreLeftForTheGame() {
        Scene scene = scene(", \"pods\": { \"radius\": 400 }");
        SceneException tooEarly = assertThrows(SceneException.class, () -> scene.root().done());
        assertEquals("s.json:2:63: pods: found an unknown field, expected one of \"name\", \"game\", \"players\", "
            + "\"field\", \"impacts\", \"motion\", \"time\", \"accuracy\"", tooEarly.getMessage());
        assertEquals(400, scene.root().block("pods").positive("radius"));
        scene.root().done();
    }

    private static Field field(String walls) {
        return scene(", \"field\": { \"width\": 20, \"height\": 10, \"walls\": " + walls + " }").field().get();
    }

    private static Scene scene(String more) {
        return SceneReader.read("{ " + REQUIRED + more + " }", "s.json");
    }
}
