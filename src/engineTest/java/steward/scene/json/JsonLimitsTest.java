package steward.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A file beyond a limit is refused at the first value too many, before the rest is read. */
class JsonLimitsTest {

    @Test
    void anArrayEndsAtAThousandElements() {
        JsonTree.read("{\"a\":[" + "5,".repeat(999) + "5]}", "s.json", "a scene");
        // "{"a":[" are 6 characters, each element is two: the element 1001 is at column 7 + 2000
        assertEquals("s.json:1:2007: a: found more than 1000 elements, expected at most 1000",
            refusal("{\"a\":[" + "5,".repeat(1000) + "5]}"));
    }

    /** Text behind the limit is not even looked at: it is not JSON here. */
    @Test
    void nothingIsReadBeyondTheLimit() {
        assertEquals("s.json:1:2007: a: found more than 1000 elements, expected at most 1000",
            refusal("{\"a\":[" + "5,".repeat(1000) + "5 this is not JSON"));
    }

    @Test
    void anObjectEndsAtAHundredFields() {
        String fields = IntStream.range(100, 201).mapToObj(k -> "\"" + k + "\":1").collect(Collectors.joining(","));
        // each of the 100 fields before is 8 characters with its comma
        assertEquals("s.json:1:802: 200: found more than 100 fields, expected at most 100",
            refusal("{" + fields + "}"));
    }

    @Test
    @Tag("slow")
    void theWholeFileEndsAtAQuarterOfAMillionValues() {
        String row = "[" + "1,".repeat(999) + "1]";
        String text = "{\"a\":[" + String.join(",", Collections.nCopies(251, row))
            + "]}";
        assertTrue(refusal(text).endsWith(": found more than 250000 values, expected at most 250000 in a file"),
            refusal(text));
    }

    @Test
    void nestingEndsAtSixteen() {
        JsonTree.read("{\"a\":" + "[".repeat(15) + "]".repeat(15) + "}", "s.json", "a scene");
        assertEquals("s.json:1:21: a" + "[0]".repeat(15) + ": found nesting deeper than 16, expected at most 16",
            refusal("{\"a\":" + "[".repeat(1000)));
    }

    @Test
    void textsEndAtAThousandCharactersAndNamesAtAHundred() {
        JsonTree.read("{\"" + "n".repeat(100) + "\":\"" + "\ud83d\ude00".repeat(1000) + "\"}", "s.json", "a scene");
        assertEquals("s.json:1:6: a: found a text of 1001 characters, expected at most 1000",
            refusal("{\"a\":\"" + "x".repeat(1001) + "\"}"));
        assertEquals("s.json:1:2: found a field's name of 101 characters, expected at most 100",
            refusal("{\"" + "n".repeat(101) + "\":1}"));
    }

    private static String refusal(String text) {
        return assertThrows(SceneException.class, () -> JsonTree.read(text, "s.json", "a scene")).getMessage();
    }
}
