package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A recorded command is found by its bytes, whatever stands in it and before it. */
class RecordedTurnTest {

    private static final List<String> COMMANDS = List.of("[{\"x\":1,\"y\":-2.5,\"thrust\":100}]", "null",
        "\"a]\\\"b,[\\\\\"", "{\"text\":\"}{\\\\\\\"],\",\"more\":[[],{}]}", "12", "\"\\\\\"", "[]", "-0.5");

    private static RecordedTurn turn(String commands) {
        return new RecordedTurn(1, commands.getBytes(StandardCharsets.UTF_8), new String[COMMANDS.size()], null,
            null, null, null, null, "turn");
    }

    private static boolean has(RecordedTurn turn, int player, String command) {
        byte[] json = (command + "more").getBytes(StandardCharsets.UTF_8);
        return turn.hasCommand(player, json, json.length - 4);
    }

    @Test
    void eachIsFoundAtItsPlaceOnly() {
        RecordedTurn turn = turn("[" + String.join(",", COMMANDS) + "]");
        for (int player = 0; player < COMMANDS.size(); player++) {
            for (int other = 0; other < COMMANDS.size(); other++) {
                assertEquals(player == other, has(turn, player, COMMANDS.get(other)), player + ", " + other);
            }
            assertEquals(player != 1, turn.hasCommand(player));
        }
        assertFalse(has(turn, COMMANDS.size(), ""), "one more");
    }

    @Test
    void anotherSpellingOrAPartIsNotFound() {
        assertTrue(has(turn("[12,[3]]"), 0, "12"));
        assertFalse(has(turn("[12,[3]]"), 0, "1"));
        assertFalse(has(turn("[12,[3]]"), 1, "[3]]"));
        assertFalse(has(turn("[ 12,[3]]"), 0, "12"));
        assertFalse(has(turn("[12 ,[3]]"), 0, "12"));
        assertFalse(has(turn("[12.0,[3]]"), 0, "12"));
        assertFalse(has(turn("[]"), 0, "12"));
        assertFalse(has(turn("[]"), 1, ""));
    }

    @Test
    void timesAreOf64BitsOrRefusedByName() {
        byte[] times = "{\"answerNanos\":[9223372036854775807,-9223372036854775809,1.5]}"
            .getBytes(StandardCharsets.UTF_8);
        RecordedTurn turn = new RecordedTurn(1, new byte[0], new String[3], null, null, null, null, times, "a:2");
        assertEquals(Long.MAX_VALUE, turn.nanos(0));
        assertEquals("a:2: times: answerNanos[1]: found -9223372036854775809, expected a whole number below 2^63",
            assertThrows(ReplayException.class, () -> turn.nanos(1)).getMessage());
        assertEquals(0, turn.nanos(2));
    }
}
