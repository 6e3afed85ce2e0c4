package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.scene.Accuracy;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import steward.scene.SceneText;
import steward.scene.json.SceneException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * The schema of scenes says what their reader does: scenes spoilt at random in seeded ways are accepted by both, or
 * refused by both, except for rules that no schema can state.
 */
@Execution(ExecutionMode.CONCURRENT)
class SceneSchemaTest {

    private static final Schema SCHEMA = Schemas.open("scene");

    /** Every block and every kind of wall, with all their fields. */
    static final String ALL = """
        { "$schema": "scene.schema.json", "name": "all", "game": "pod-race", "players": 1,
          "field": { "x": -5, "y": 3, "width": 16000, "height": 9000,
            "walls": [ { "type": "segment", "ax": 0, "ay": 0, "bx": 1, "by": 0, "restitution": 0.5 },
                       { "type": "half-plane", "x": 0, "y": 0, "insideX": 1, "insideY": 0, "restitution": 1 },
                       { "type": "arena", "x": 8000, "y": 4000, "radius": 9000, "restitution": 0 } ],
            "bumpers": [ { "x": 1, "y": 2, "radius": 3, "restitution": 0.5 } ] },
          "impacts": { "minimumImpulse": 120, "minimumImpulseAtWalls": true, "deadZone": 1, "separatingPairs": "react",
            "batchWindow": 0.5, "scanOrder": "ascending", "pushOut": 2, "maximumImpactsPerTurn": 7 },
          "motion": { "drag": 0.15, "velocity": "truncate", "position": "round", "first": "velocity" },
          "pods": { "perPlayer": 1, "radius": 400, "mass": 1, "restitution": 0.9, "maximumThrust": 100 },
          "race": { "laps": 1, "checkpointRadius": 600, "shift": true, "jitter": 30, "turnsWithoutCheckpoint": 9,
            "maximumTurns": 9, "maps": [ { "checkpoints": [ { "x": 1, "y": 2 }, { "x": 1, "y": 1 } ] } ] },
          "time": { "firstAnswerMs": 1000, "answerMs": 75 },
          "accuracy": { "advance": "step", "steps": 4, "arithmetic": "double" } }
        """;

    /** Values that stand in place of one; {@code raw:} texts become JSON as they are. */
    private static final List<String> VALUES = List.of("0", "-0", "1", "-1", "2", "0.5", "2.0", "3e0", "1.5e0", "16",
        "17", "64", "100", "101", "651", "1000", "1001", "1024", "1025", "1e6", "1000001", "3600001", "1e-12", "9e-13",
        "1e12", "1.1e12", "-1e12", "-1.1e12", "1e999", "1e-5", "true", "false", "null", "[]", "{}", "[{}]", "[5]",
        "\"\"", "\" \"", "\"x\"", "\"400\"", "\"box\"", "\"official\"", "\"react\"", "\"ignore\"", "\"event\"",
        "\"step\"", "\"exact\"", "\"round-half-away\"", "\"truncate-snap\"", "\"position\"", "\"infinite\"",
        "\"pod-race\"", "\"a\\u0007b\"", "{\"type\":\"box\"}",
        "{\"type\":\"box\",\"restitution\":0.5}", "{\"maxPositionError\":0.01,\"share\":0.999}",
        "{\"maxPositionError\":0,\"share\":1}", "{\"advance\":\"event\",\"arithmetic\":\"double\"}");

    /** The rules of the reader that the schema cannot state, by what its refusal says. */
    private enum Beyond {
        FIRST_TWO_CHECKPOINTS_APART("the first two in the same place"),
        INSIDE_VECTOR_OF_LENGTH_ONE("length of the inside vector"),
        ENDS_OF_A_SEGMENT_APART("length of a segment"),
        ARENA_LARGER_THAN_A_POD("less than the radius of the arena");

        private final String words;

        Beyond(String words) {
            this.words = words;
        }
    }

    @ParameterizedTest
    @CsvSource({"duel", "mad-pod-racing", "mad-pod-racing-silver", "walled-race"})
    void shippedScenesAreValid(String name) {
        assertEquals(List.of(), Schemas.problems(SCHEMA, SceneFiles.load("config/scenes/" + name + ".json").text()));
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void spoiltScenesAreRefusedByBothOrNeither() {
        List<JsonNode> scenes = new ArrayList<>();
        scenes.add(JsonMapper.shared().readTree(ALL));
        SceneFiles.shipped().forEach(name -> scenes.add(JsonMapper.shared().readTree(SceneFiles.load(name).text())));
        scenes.removeIf(scene -> !scene.get("game").stringValue().equals(Schemas.POD_RACE));
        SplitMix64 random = new SplitMix64(5);
        Set<Beyond> seen = EnumSet.noneOf(Beyond.class);
        JsonNode point = JsonMapper.shared().readTree(ALL.replace("\"bx\": 1", "\"bx\": 0"));
        assertTrue(refusal(point.toString()).contains(Beyond.ENDS_OF_A_SEGMENT_APART.words));
        assertEquals(List.of(), Schemas.problems(SCHEMA, point.toString()));
        seen.add(Beyond.ENDS_OF_A_SEGMENT_APART);     // rare by lot
        List<String> differences = new ArrayList<>();
        int accepted = 0;
        int mutations = TestSize.of(2000, 8000);
        for (int k = 0; k < mutations; k++) {
            JsonNode scene = scenes.get(random.nextInt(2) == 0 ? 0 : random.nextInt(scenes.size())).deepCopy();
            for (int change = 0; change <= random.nextInt(2); change++) {
                spoil(scene, random);
            }
            String text = scene.toString().replaceAll("\"raw:((?:[^\"\\\\]|\\\\.)*)\"", "$1").replace("\\\"", "\"")
                .replace("\\\\", "\\");
            String refusal = refusal(text);
            List<String> problems = Schemas.problems(SCHEMA, text);
            accepted += refusal == null ? 1 : 0;
            if (refusal != null && problems.isEmpty()) {
                List<Beyond> rules = EnumSet.allOf(Beyond.class).stream()
                    .filter(rule -> refusal.contains(rule.words)).toList();
                seen.addAll(rules);
                if (rules.isEmpty()) {
                    differences.add("only the reader refuses: " + refusal + "\n" + text);
                }
            } else if (refusal == null && !problems.isEmpty()) {
                differences.add("only the schema refuses: " + problems + "\n" + text);
            }
        }
        assertEquals(List.of(), differences.subList(0, Math.min(5, differences.size())));
        assertEquals(EnumSet.allOf(Beyond.class), seen, "rules that are beyond a schema, each met");
        assertTrue(accepted > mutations / 10 && accepted < mutations * 9 / 10, accepted + " accepted");
    }

    /** Returns the refusal of the reader; on a rung of its own, so that a demand of accuracy needs no figures. */
    private static String refusal(String text) {
        try {
            TestScenes.TYPES.open(SceneReader.read(new SceneText(text, "s.json"), Accuracy.step(1)));
            return null;
        } catch (SceneException problem) {
            return problem.getMessage();
        }
    }

    /** One change somewhere: a value replaced, a field removed, renamed or added, an element removed or repeated. */
    private static void spoil(JsonNode scene, SplitMix64 random) {
        List<JsonNode> containers = new ArrayList<>();
        collect(scene, containers);
        JsonNode node = containers.get(random.nextInt(containers.size()));
        String value = "raw:" + VALUES.get(random.nextInt(VALUES.size()));
        if (node instanceof ArrayNode array && !array.isEmpty()) {
            int at = random.nextInt(array.size());
            switch (random.nextInt(16)) {
                case 0 -> repeat(array, at, random.nextInt(2) == 0 ? 65 : 1001);
                case 1, 2, 3, 4 -> array.remove(at);
                case 5, 6, 7, 8 -> array.set(at, value);
                case 9, 10, 11, 12 -> array.set(0, array.get(at).deepCopy());
                default -> array.add(array.get(at).deepCopy());
            }
        } else if (node instanceof ObjectNode object && !object.isEmpty()) {
            List<String> names = List.copyOf(object.propertyNames());
            String name = names.get(random.nextInt(names.size()));
            switch (random.nextInt(8)) {
                case 0 -> object.remove(name);
                case 1 -> object.set(name + "s", object.remove(name));
                case 2 -> object.put("more", value);
                default -> object.put(name, value);
            }
        }
    }

    private static void repeat(ArrayNode array, int at, int length) {
        while (array.size() < length) {
            array.add(array.get(at).deepCopy());
        }
    }

    private static void collect(JsonNode node, List<JsonNode> containers) {
        if (node.isContainer()) {
            containers.add(node);
            node.forEach(child -> collect(child, containers));
        }
    }
}
