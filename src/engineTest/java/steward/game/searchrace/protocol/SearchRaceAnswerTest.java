package steward.game.searchrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.CodecText;
import steward.game.GameJson;
import steward.game.TextCodec;
import steward.game.searchrace.SearchRace;
import steward.json.JsonObject;

/** Answers of bots in both protocols: what is taken, and what is said of the others. */
class SearchRaceAnswerTest {

    private final SearchRace race = SearchRaces.onMap("0 0;5000 0;10000 0");
    private final GameJson codec = SearchRaces.changed().codec(race);
    private final TextCodec text = SearchRaces.changed().textCodec(race).orElseThrow();

    private String read(String line) {
        return CodecText.read(codec, 0, line);
    }

    private String readText(String line) {
        return CodecText.read(text, 0, line);
    }

    @Test
    void bothFormsAreTaken() {
        assertNull(read("{\"x\":1.5,\"y\":-2,\"thrust\":200,\"message\":\"hi\"}"));
        assertEquals(SearchRace.Order.TOWARD, race.order());
        assertEquals(1.5, race.targetX());
        assertEquals(200, race.thrust());
        assertEquals("hi", codec.message(0));
        assertNull(read("{\"thrust\":100.0,\"turn\":-18}"));
        assertEquals(SearchRace.Order.TURN, race.order());
        assertEquals(-18, race.degrees());
        assertEquals("{\"command\":{\"turn\":-18,\"thrust\":100}}", new String(JsonObject.of(out -> {
            out.writeName("command");
            codec.writeCommand(out, 0);
        }), StandardCharsets.UTF_8));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        {"thrust":1}                     | found neither x and y nor turn, expected one of them
        {"x":1,"thrust":1}               | y: found nothing, expected a number
        {"x":1,"y":2}                    | thrust: found nothing, expected a whole number 0..200
        {"x":1,"y":2,"thrust":201}       | thrust: found 201, expected a whole number 0..200
        {"x":1,"y":2,"thrust":1.5}       | thrust: found 1.5, expected a whole number 0..200
        {"turn":19,"thrust":1}           | turn: found 19, expected a whole number -18..18
        {"turn":1,"x":1,"y":2,"thrust":1}| turn: found beside x and y, expected either turn, or x and y
        {"x":1,"x":1,"y":2,"thrust":1}   | x: found twice, expected once
        {"x":"1","y":2,"thrust":1}       | x: found "1", expected a finite number
        {"x":1,"y":2,"thrst":1}| thrst: unknown field, expected one of message, thrust, turn, x, y; did you mean thrust?
        {"x":1,"y":2,"thrust":1,"debug":true} | debug: unknown field, expected one of message, thrust, turn, x, y
        []                               | found an array, expected an object with message, thrust, turn, x, y
        {"x":1,"y":2,"thrust":1} x       | not JSON
        """)
    void faultsAreSaid(String line, String wrong) {
        String found = read(line);
        assertTrue(found != null && (found.equals(wrong) || wrong.equals("not JSON") && found.startsWith(wrong)
            || wrong.startsWith("debug") && found.startsWith(wrong)), found);
    }

    /** The lines as the published referee reads them. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        `1 2 3`            | ``
        `+1 -2 0200 hello` | ``
        `EXPERT -18 200 `  | ``
        `EXPERT 18 200  x` | ``
        `1 2 3\r`          | ``
        `1  2 3`           | `Y: found "", expected a whole number`
        ` 1 2 3`           | `X: found "", expected a whole number`
        `1.0 2 3`          | `X: found "1.0", expected a whole number`
        `1 2 201`          | `THRUST: found "201", expected a whole number 0..200`
        `EXPERT 19 1`      | `ANGLE: found "19", expected a whole number -18..18`
        `expert 1 1`       | `X: found "expert", expected a whole number`
        `1 2`              | `found "1 2", expected X Y THRUST or EXPERT ANGLE THRUST with single blanks`
        """)
    void linesAreReadAsTheRefereeDoes(String line, String wrong) {
        assertEquals(wrong.isEmpty() ? null : wrong, readText(line.replace("\\r", "\r")));
    }

    /** Asked for with one message, told from the next turn on; a turn without a pass says 2.0, as Java prints it. */
    @Test
    void aMessageWithDebugAsksForTimes() {
        assertEquals("0 0 0 0 0 0\n", CodecText.turn(text, 0));
        assertNull(readText("5000 0 200 no debug now"));
        assertEquals("no debug now", text.message(0));
        assertTrue(race.asksForTimes());
        race.play();
        assertEquals("0 200 0 170 0 0\n2.0\n", CodecText.turn(text, 0));
        race.set(4300, 0, 400, 0, 0, 0, 10, 2);
        assertNull(readText("EXPERT 0 0"));
        race.play();
        assertEquals("1 4700 0 340 0 0\n0.25\n", CodecText.turn(text, 0));
    }

    @Test
    void theSetupIsTheWholeWay() {
        assertEquals("9\n" + "5000 0\n10000 0\n0 0\n".repeat(3), CodecText.setup(text, 0));
    }
}
