package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.scene.json.SceneException;

/**
 * Every kind of mistake in the common part of a scene ends in an error with its exact place and words. A row has
 * a part of {@link #GOOD}, what stands there instead, and the message; places count in GOOD.
 */
class SceneErrorsTest {

    private static final String GOOD = """
        { "name": "walls", "game": "any", "players": 2,
          "field": { "width": 16000, "height": 9000,
            "walls": [ { "type": "segment", "ax": 0, "ay": 0, "bx": 5, "by": 5 },
                       { "type": "half-plane", "x": 0, "y": 0, "insideX": 1, "insideY": 0 },
                       { "type": "arena", "x": 0, "y": 0, "radius": 9 } ],
            "bumpers": [ { "x": 1, "y": 2, "radius": 3, "restitution": 0.5 } ] },
          "impacts": { "minimumImpulse": 120, "separatingPairs": "react", "batchWindow": 1e-5,
                       "minimumImpulseAtWalls": true, "maximumImpactsPerTurn": 50 },
          "motion": { "drag": 0.15, "velocity": "truncate", "position": "round" },
          "time": { "firstAnswerMs": 1000, "answerMs": 75 },
          "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    @Test
    void theSceneWithoutMistakesReads() {
        read(GOOD);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "radius": 3 | "radius": "400" | 6:46: field.bumpers[0].radius: found the text "400", expected a number above 0
        "name": "walls" | "name": 7 | 1:11: name: found 7, expected a text
        "name": "walls" | "name": " " | 1:11: name: found " ", expected a text
        "game": "any", | `` | 1:1: game: found nothing, expected a text
        "players": 2 | "players": 17 | 1:46: players: found 17, expected a whole number 0..16
        "players": 2 | "players": 2.5 | 1:46: players: found 2.5, expected a whole number 0..16
        "players": 2 | "players": "2" | 1:46: players: found the text "2", expected a whole number 0..16
        "players": 2 | "players": null | 1:46: players: found null, expected a whole number 0..16
        "width": 16000 | "width": 0 | 2:23: field.width: found 0, expected a number above 0
        "width": 16000 | "width": 1e999 | 2:23: field.width: found 1e999, expected a number above 0
        "width": 16000 | "width": 1e13 | 2:23: field.width: found 1e13, expected 1e-12..1e12
        "name": "walls" | "name": "a\\u001b[31mred" | 1:11: name: found "a?[31mred", expected a name without control \
        characters
        "width": 16000 | "width": [] | 2:23: field.width: found an empty array, expected a number above 0
        "height": 9000 | "heigth": 9000 | 2:12: field.height: found nothing, expected a number above 0; the nearest \
        field here is "heigth" in line 2
        "drag": 0.15 | "drag": -0.5 | 9:23: motion.drag: found -0.5, expected a number 0..1
        "drag": 0.15 | "drag": 1.0001 | 9:23: motion.drag: found 1.0001, expected a number 0..1
        "answerMs": 75 | "answerMs": 3600001 | 10:48: time.answerMs: found 3600001, expected a whole number 1..3600000
        "radius": 3 | "radius": -3 | 6:46: field.bumpers[0].radius: found -3, expected a number above 0
        "restitution": 0.5 | "restitution": 1.5 | 6:64: field.bumpers[0].restitution: found 1.5, expected a number 0..1
        "radius": 9 | "radius": true | 5:61: field.walls[2].radius: found true, expected a number above 0
        "type": "arena" | "type": "arna" | 5:26: field.walls[2].type: found "arna", expected one of "arena", "box", \
        "half-plane", "segment"; did you mean "arena"?
        "type": "arena", | `` | 5:16: field.walls[2].type: found nothing, expected one of "arena", "box", \
        "half-plane", "segment"
        "insideX": 1 | "insideX": 2 | 4:16: field.walls[1]: found length of the inside vector 2.0, expected 1
        "bx": 5, "by": 5 | "bx": 0, "by": 0 | 3:16: field.walls[0]: found length of a segment 0.0, expected finite and \
        above 0
        "ax": 0 | "ax": "left" | 3:43: field.walls[0].ax: found the text "left", expected a number -1e12..1e12
        "bumpers": [ { | "bumpers": [ 4, { | 6:18: field.bumpers[0]: found 4, expected an object
        "minimumImpulse": 120 | "minimumImpulse": -1 | 7:34: impacts.minimumImpulse: found -1, expected a number 0..1e12
        "minimumImpulse": 120 | "minimumImpulse": 0.0 | 7:34: impacts.minimumImpulse: found 0.0, expected above 0, \
        because separating pairs react
        "minimumImpulse": 120, | `` | 7:14: impacts.minimumImpulse: found nothing, expected above 0, because \
        separating pairs react
        "react" | "ignore" | 7:83: impacts.batchWindow: found 1e-5, expected 0, because only approaching pairs react
        "react" | "reacts" | 7:58: impacts.separatingPairs: found "reacts", expected one of "ignore", "react"; did you \
        mean "react"?
        "batchWindow": 1e-5 | "batchWindow": 2 | 7:82: impacts.batchWindow: found 2, expected a number 0..1
        AtWalls": true | AtWalls": "yes" | 8:41: impacts.minimumImpulseAtWalls: found "yes", expected true or false
        PerTurn": 50 | PerTurn": 1000001 | 8:72: impacts.maximumImpactsPerTurn: found 1000001, expected a whole number \
        1..1000000
        PerTurn": 50 | PerTurn": 0 | 8:72: impacts.maximumImpactsPerTurn: found 0, expected a whole number 1..1000000
        "truncate" | "truncat" | 9:41: motion.velocity: found "truncat", expected one of "round-half-away", \
        "truncate", "truncate-snap"; did you mean "truncate"?
        "round" | "floor" | 9:65: motion.position: found "floor", expected one of "round", "round-half-away", \
        "truncate-snap"
        "event" | "evnet" | 11:28: accuracy.advance: found "evnet", expected one of "event", "step"; did you mean \
        "event"?
        "double" | "offical" | 11:51: accuracy.arithmetic: found "offical", expected one of "official", "double", \
        "compensated", "exact"; did you mean "official"?
        "double" | "exakt" | 11:51: accuracy.arithmetic: found "exakt", expected one of "official", "double", \
        "compensated", "exact"; did you mean "exact"?
        "event", "arithmetic": "double" | "step", "arithmetic": "double" | 11:15: accuracy.steps: found nothing, \
        expected a whole number 1..1024
        "event" | "step", "steps": 0 | 11:45: accuracy.steps: found 0, expected a whole number 1..1024
        "event" | "step", "steps": 1025 | 11:45: accuracy.steps: found 1025, expected a whole number 1..1024
        "event", "arithmetic": "double" | "step", "steps": 4, "arithmetic": "exact" | 11:62: accuracy.arithmetic: \
        found "exact", expected "double", because steps look for overlaps and compute no times of impact
        "accuracy" | "acuracy" | 1:1: accuracy: found nothing, expected an object; the nearest field here is "acuracy" \
        in line 11
        "drag": 0.15 | "drag": 0, "drga": 1 | 9:26: motion.drga: found an unknown field, expected one of "drag", \
        "velocity", "position", "first"; did you mean "drag"?
        "radius": 3 | "radius": 3, "mass": 1 | 6:49: field.bumpers[0].mass: found an unknown field, expected one of \
        "x", "y", "radius", "restitution"
        "width": 16000 | "width": 1, "width": 2 | 2:26: field.width: found the field a second time, expected it once \
        (the first is in line 2)
        """)
    void mistakesAreNamedWithTheirPlace(String part, String instead, String message) {
        assertTrue(GOOD.contains(part), part);
        String text = GOOD.replace(part, instead);
        assertEquals("s.json:" + message, assertThrows(SceneException.class, () -> read(text)).getMessage());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "circle"                             | field.walls: found "circle", expected "box"
        7                                    | field.walls: found 7, expected "box", an object or an array of walls
        { "restitution": 1 }                 | field.walls.type: found nothing, expected "box"
        { "type": "box", "restitution": -1 } | field.walls.restitution: found -1, expected a number 0..1
        { "type": "arena" }                  | field.walls.type: found "arena", expected "box"
        [ "box" ]                            | field.walls[0]: found "box", expected an object
        [ { "type": "bax" } ]                | field.walls[0].type: found "bax", expected one of "arena", "box"
        """)
    void wallsAreABoxOrAList(String walls, String message) {
        String text = GOOD.replaceFirst("(?s)\"walls\": .*?],", "\"walls\": " + walls + ",");
        String found = assertThrows(SceneException.class, () -> read(text)).getMessage();
        assertTrue(found.replaceFirst("s.json:3:\\d+: ", "").startsWith(message), found);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        ``                  | s.json:1:1: found an empty file, expected a scene in JSON
        `  \t `             | s.json:1:1: found an empty file, expected a scene in JSON
        []                  | s.json:1:1: found an empty array, expected an object
        ` "scene"`          | s.json:1:2: found "scene", expected an object
        {} {}               | s.json:1:4: found more after the end of a scene, expected the end of the file
        """)
    void aFileIsOneObject(String text, String message) {
        assertEquals(message, assertThrows(SceneException.class, () -> read(text)).getMessage());
    }

    /** The parser's place, in our words. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        { "a": 1, }  | 1:11 | found '}', expected the name of a field in double quotes
        { "a": 1     | 1:9  | found the end of the text within the JSON, expected all of it
        { "a": [     | 1:9  | found the end of the text within the JSON, expected all of it
        { "a": 01 }  | 1:9  | found a number that begins with a zero too many, expected none
        { "a": NaN } | 1:11 | found a number that is not finite, expected digits
        { 'a': 1 }   | 1:3  | found ''', expected the name of a field in double quotes
        { "a": "b }  | 1:12 | found the end of the text within the JSON, expected all of it
        { "a": 1 } } | 1:12 | found '}', but nothing that it closes
        { "a": tru } | 1:8  | found tru, expected a value: a text in double quotes, a number, an object
        """)
    void whatIsNotJsonIsSaidSo(String text, String place, String why) {
        String message = assertThrows(SceneException.class, () -> read(text)).getMessage();
        assertTrue(message.startsWith("s.json:" + place + ": not JSON: " + why), message);
        assertFalse(message.contains("Source") || message.contains("Feature"), message);
    }

    /** Such an error is located behind what is too much. */
    @Test
    void theParserKeepsItsBounds() {
        assertEquals("s.json:1:17: " + "[0]".repeat(16) + ": found nesting deeper than 16, expected at most 16",
            assertThrows(SceneException.class, () -> read("[".repeat(1000))).getMessage());
        assertEquals("s.json:1:2001: not JSON: found a number of 2000 characters, expected at most 1000",
            assertThrows(SceneException.class, () -> read("1".repeat(2000))).getMessage());
    }

    @Test
    void theNameOfASchemaIsATextForEditors() {
        read(GOOD.replace("{ \"name\"", "{ \"$schema\": \"scene.json\", \"name\""));
        assertEquals("s.json:1:14: $schema: found 7, expected a text", assertThrows(SceneException.class,
            () -> read(GOOD.replace("{ \"name\"", "{ \"$schema\": 7, \"name\""))).getMessage());
    }

    private static void read(String text) {
        SceneReader.read(text, "s.json").root().done();
    }
}
