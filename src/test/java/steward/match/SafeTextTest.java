package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** Part of a bot's line that is quoted in errors and replays. */
class SafeTextTest {

    @Test
    void controlsAndReorderingCharactersBecomeQuestionMarks() {
        assertEquals("a\\u001B[2J\\tb\\u202Ec\\u009Bd", line("a\u001b[2J\tb\u202Ec\u009Bd"));
        assertEquals("\u05D0\u00E4", line("\u05D0\u00E4"));
    }

    @Test
    void aLongLineIsCutWithoutHalfACharacter() {
        assertEquals("x".repeat(119) + "...", line("x".repeat(119) + "\uD83D\uDE00 and more"));
    }

    @Test
    void whatIsWrongWithAnAnswerMayQuoteIt() {
        byte[] answer = "0 \u000001 100".getBytes(StandardCharsets.UTF_8);
        assertEquals("Y: found \"\\u000001\uFFFD\", expected a finite number; received: 0 \\u000001 100",
            SafeText.fault("Y: found \"\u000001\uD800\", expected a finite number", answer, answer.length));
    }

    private static String line(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        return SafeText.line(bytes, bytes.length);
    }
}
