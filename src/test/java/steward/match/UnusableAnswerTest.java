package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.InProcessPlayer;
import steward.bot.TestBots;

/** Message about an answer that cannot be used: the field, the value, what was expected, and the line received. */
@Timeout(20)
class UnusableAnswerTest {

    /** A bot of one pod that gives the same answer every turn. */
    private static InProcessPlayer saying(String answer) {
        return new InProcessPlayer("A", TestBots.answering(line -> {
            if (answer != null && answer.startsWith("throw ")) {
                throw new IllegalStateException(answer.substring(6));
            }
            return answer;
        }));
    }

    private static final String GOOD = "{\"pods\":[{\"x\":1,\"y\":2,\"thrust\":3}]}";

    private static final String ARRAY = "found an array, expected an object with message, pods; received: ";
    private static final String SMILE = "\uD83D\uDE00";

    private static MatchResult.PlayerResult faultOf(String answer) throws InterruptedException {
        MatchResult result = new Referee(TestScenes.open("duel"), 1, List.of(saying(answer), saying(GOOD)),
            TimeControl.UNLIMITED, new MatchListener() { }).play();
        assertNull(result.players().get(1).fault());
        return result.players().get(0);
    }

    private static String pod(String fields) {
        return "{\"pods\":[{" + fields + "}]}";
    }

    private static Arguments received(String answer, String wrong) {
        return Arguments.of(answer, wrong + "; received: " + answer);
    }

    static Stream<Arguments> answers() {
        return Stream.of(
            Arguments.of(null, "answered null"),
            Arguments.of("throw boom", "threw java.lang.IllegalStateException: boom"),
            Arguments.of(GOOD + "\n" + GOOD, "answered 2 lines instead of 1"),
            received("", "found nothing, expected an object with message, pods"),
            received("[]", "found an array, expected an object with message, pods"),
            received("12", "found 12, expected an object with message, pods"),
            received("{}", "pods: found nothing, expected an array of 1 pod"),
            received("{\"pods\":7}", "pods: found 7, expected an array of 1 pod"),
            received("{\"pods\":[]}", "pods: found 0, expected 1 pod"),
            received("{\"pods\":[{\"x\":1,\"y\":2,\"thrust\":3},{\"x\":1,\"y\":2,\"thrust\":3}]}",
                "pods: found more than 1, expected 1 pod"),
            received("{\"pods\":[5]}", "pods[0]: found 5, expected an object"),
            received("{\"pod\":[]}", "pod: unknown field, expected one of message, pods; did you mean pods?"),
            received("{\"message\":5}", "message: found 5, expected a string"),
            received(GOOD + "{}", "found more after the closing }, expected one object a line"),
            received("{\"pods\":[],\"pods\":[]}", "pods: found 0, expected 1 pod"),
            received(pod("\"x\":1,\"y\":2"),
                "pods[0]: found none of thrust, shield, boost, expected exactly one"),
            received(pod("\"x\":1,\"y\":2,\"thrust\":1,\"shield\":true"),
                "pods[0].shield: found more than one of thrust, shield, boost, expected exactly one"),
            received(pod("\"y\":2,\"thrust\":1"), "pods[0].x: found nothing, expected a number"),
            received(pod("\"x\":1,\"thrust\":1"), "pods[0].y: found nothing, expected a number"),
            received(pod("\"x\":1,\"x\":1"), "pods[0].x: found twice, expected once"),
            received("{\"message\":\"a\",\"message\":\"b\"}", "message: found twice, expected once"),
            received(pod("\"x\":\"1\""), "pods[0].x: found \"1\", expected a finite number"),
            received(pod("\"x\":1e999"), "pods[0].x: found 1e999, expected a finite number"),
            received(pod("\"thrust\":201"), "pods[0].thrust: found 201, expected a whole number 0..200"),
            received(pod("\"thrust\":-1"), "pods[0].thrust: found -1, expected a whole number 0..200"),
            received(pod("\"thrust\":100.5"), "pods[0].thrust: found 100.5, expected a whole number 0..200"),
            received(pod("\"thrust\":99999999999"),
                "pods[0].thrust: found 99999999999, expected a whole number 0..200"),
            received(pod("\"shield\":false"), "pods[0].shield: found false, expected true (or leave it out)"),
            received(pod("\"boost\":1"), "pods[0].boost: found 1, expected true (or leave it out)"),
            received(pod("\"trust\":100"), "pods[0].trust: unknown field, expected one of boost, shield, thrust, x, y"
                + "; did you mean thrust?"),
            received(pod("\"colour\":100"),
                "pods[0].colour: unknown field, expected one of boost, shield, thrust, x, y"),
            // A long line is shortened, but not inside a character: Java keeps some as pairs, and a half is no text.
            Arguments.of("[" + " ".repeat(10_000) + "]", ARRAY + "[" + " ".repeat(119) + "..."),
            Arguments.of("[" + " ".repeat(118) + SMILE + SMILE + "]", ARRAY + "[" + " ".repeat(118) + "..."),
            // The line is shown on terminals.
            Arguments.of("[\u001b[31m", ARRAY + "[\\u001B[31m"));
    }

    @ParameterizedTest
    @MethodSource("answers")
    void reasonInFull(String answer, String reason) throws InterruptedException {
        MatchResult.PlayerResult player = faultOf(answer);

        assertEquals(reason, player.fault());
        assertEquals(reason, player.out());
        assertEquals(1, player.rank());
    }

    /** Half of a character must not reach a replay, where it could not be written. In a line it is a question mark. */
    @Test
    void halfCharactersAreReplaced() throws InterruptedException {
        assertTrue(faultOf("{\"\uDC00\":1}").fault().startsWith("?: unknown field"));
        assertTrue(faultOf("{\"pods\":\"\\ud83d\"}").fault().startsWith("pods: found \"\uFFFD\", expected"));
    }

    @ParameterizedTest
    @MethodSource("malformed")
    void malformedJsonIsSaidWithItsColumn(String answer, int column) throws InterruptedException {
        String fault = faultOf(answer).fault();

        assertTrue(fault.startsWith("not JSON, column " + column + ": "), fault);
        assertTrue(fault.endsWith("; received: " + answer), fault);
    }

    static Stream<Arguments> malformed() {
        return Stream.of(Arguments.of("{\"pods\":[", 10), Arguments.of("hello", 1), Arguments.of("{'pods':[]}", 2),
            Arguments.of(pod("\"x\":NaN"), 18), Arguments.of(pod("\"x\":01"), 16));
    }

    @Test
    void halfCharactersInMessagesAreReplaced() throws InterruptedException {
        StringBuilder heard = new StringBuilder();
        MatchListener listener = new MatchListener() {
            @Override
            public void played(Turn turn) {
                heard.append(turn.message(0));
            }
        };
        String answer = GOOD.replace("]}", "],\"message\":\"a\\ude00b\"}");
        new Referee(TestScenes.open("duel"), 1, List.of(saying(answer), saying(null)),
            TimeControl.UNLIMITED, listener).play();

        assertEquals("a\uFFFDb", heard.toString());
    }

    /** Numbers and names beyond what the JSON reader takes are the bot's fault, not the referee's end. */
    @Test
    void whatTheJsonReaderRefusesIsAFault() throws InterruptedException {
        for (String answer : List.of(pod("\"x\":1" + "0".repeat(2000)), pod("\"x\":0." + "1".repeat(2000)),
                "{\"" + "n".repeat(60_000) + "\":1}", "[".repeat(2000), "{\"pods\":" + "[".repeat(2000))) {
            String fault = faultOf(answer).fault();

            assertTrue(fault != null && fault.contains("; received: "), () -> answer.substring(0, 20) + ": " + fault);
        }
    }
}
