package steward.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/** Everything that the parser refuses is said without its own vocabulary. */
class JsonProblemTest {

    private static final JsonFactory FACTORY = new JsonFactory();
    private static final List<String> FOREIGN = List.of("Source", "Feature", "FEATURE", "(code", "token", "marker",
        "VALUE_", "START_", "start-object", "Object", "Array", "Constraints", "Unexpected", "Invalid",
        "what is not JSON");

    static Stream<byte[]> broken() {
        Stream<String> texts = Stream.of("{", "[1,2", "{\"a\":", "{\"a", "{\"a\":\"b", "{\"a\":\"\\", "{\"a\":\"\\u12",
            "tru",
            "{\"a\": }", "{\"a\":1 \"b\":2}", "[1 2]", "{\"a\" 1}", "{\"a\":1,}", "[1,]", "[,]", "{,}", "{a:1}",
            "{'a':1}",
            "{/*c*/}", "{\"a\":1 // c\n}", "{#c\n}", "{\"a\":01}", "{\"a\":-01}", "{\"a\":+1}", "{\"a\":.5}",
            "{\"a\":1.}",
            "{\"a\":1e}", "{\"a\":-}", "{\"a\":-x}", "{\"a\":1x}", "{\"a\":NaN}", "{\"a\":INF}", "{\"a\":-Infinity}",
            "{\"a\":nul}", "xyz", "ä", "]", "{\"a\":1]", "[1}", "{}}", "{\"a\":\"b\tc\"}", "{\"a\":\"b\nc\"}",
            "{\"a\":\"\\q\"}", "{\"a\":\"\\u12\"}", "\u0001", "\uFEFF\uFEFF{}", "[".repeat(600), "9".repeat(1200),
            "{\"" + "n".repeat(60_000) + "\":1}", "'", "\\", "(", "{\"a\":1e99999999999x", "truefalse");
        Stream<byte[]> bytes = Stream.of(new byte[] {'"', -1, '"'}, new byte[] {'"', (byte) 0xC3, 'x', '"'},
            new byte[] {-1}, new byte[] {'{', '"', -1, '"'}, new byte[] {'"', (byte) 0xE2, (byte) 0x82},
            new byte[] {'"', (byte) 0xF0, (byte) 0x90, 'x', 'x', '"'});
        return Stream.concat(texts.map(text -> text.getBytes(StandardCharsets.UTF_8)), bytes);
    }

    @ParameterizedTest
    @MethodSource("broken")
    void aProblemIsSaidInOurWords(byte[] json) {
        ours(assertThrows(JacksonException.class,
            () -> readAll(FACTORY.createParser(ObjectReadContext.empty(), json))));
        String text = new String(json, StandardCharsets.UTF_8);
        try (JsonParser parser = FACTORY.createParser(ObjectReadContext.empty(), text)) {
            readAll(parser);
        } catch (JacksonException problem) {
            ours(problem);
        }
    }

    private static void ours(JacksonException problem) {
        String message = JsonProblem.message(problem);
        assertTrue(message.startsWith("found "), message);
        for (String word : FOREIGN) {
            assertFalse(message.contains(word), message + " from " + problem.getOriginalMessage());
        }
    }

    private static void readAll(JsonParser parser) {
        while (parser.nextToken() != null) {
            parser.getString();
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        {"a" 1}      | found '1', expected a colon between a field's name and its value
        {"a":1 "b"}  | found '"', expected a comma or }
        [1 2]        | found '2', expected a comma or ]
        [1}          | found '}', expected ']'
        {"a":+1}     | found a number with a plus sign, expected one without
        {"a":1.}     | found '}' after a decimal point, expected a digit
        {"a":"\\q"}  | found 'q' after \\, expected one of \\" \\\\ \\/ \\b \\f \\n \\r \\t or \\u with \
        four hexadecimal digits
        {"a":/**/1}  | found '/', perhaps a comment; JSON has none
        """)
    void theWordsSayWhatWasExpected(String json, String message) {
        JacksonException problem = assertThrows(JacksonException.class,
            () -> readAll(FACTORY.createParser(ObjectReadContext.empty(), json)));
        assertEquals(message, JsonProblem.message(problem));
    }
}
