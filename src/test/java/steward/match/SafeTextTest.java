package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** What of a bot's line is quoted in errors and replays. */
class SafeTextTest {

    @Test
    void controlsAndReorderingCharactersBecomeQuestionMarks() {
        assertEquals("a?[2J?b?c?d", line("a\u001b[2J\tb\u202Ec\u009Bd"));
        assertEquals("\u05D0\u00E4", line("\u05D0\u00E4"));
    }

    @Test
    void aLongLineIsCutWithoutHalfACharacter() {
        assertEquals("x".repeat(119) + "...", line("x".repeat(119) + "\uD83D\uDE00 and more"));
    }

    private static String line(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        return SafeText.line(bytes, bytes.length);
    }
}
