package steward.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Text that a terminal gets of what is written. */
class TerminalOutputStreamTest {

    private static final long SEED = 12;

    private static String passed(String text) throws IOException {
        ByteArrayOutputStream terminal = new ByteArrayOutputStream();
        new TerminalOutputStream(terminal).write(text.getBytes(StandardCharsets.UTF_8));
        return terminal.toString(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @CsvSource({"0x202E", "0x202A", "0x2066", "0x2069", "0x200E", "0x200F", "0x061C", "0x009B", "0x0085", "0x07",
        "0x7F",
        "0x00"})
    void whatIsUnsafeArrivesAsAQuestionMark(int character) throws IOException {
        assertEquals("a?b", passed("a" + (char) character + "b"));
    }

    @Test
    void everythingElseArrives() throws IOException {
        String text = "plain\ttext\r\n\b caf\u00e9 \u0627\u0644 \u2013 \u201Cx\u201D \u2190 \u20ac "
            + "\uD83D\uDE80 \u00a0 \u06cc \u2202 \u205F \u206A";
        assertEquals(text, passed(text));
    }

    /** Colours and progress are sequences that begin with escape and a bracket; no other escapes pass. */
    @Test
    void coloursPassAndOtherEscapesDoNot() throws IOException {
        assertEquals("\u001b[31mfailed\u001b[0m", passed("\u001b[31mfailed\u001b[0m"));
        assertEquals("?]0;title?", passed("\u001b]0;title\u0007"));
        assertEquals("?c", passed("\u001bc"));
        assertEquals("?\u001b[K", passed("\u001b\u001b[K"));
    }

    /** A buffer may end within a character. */
    @Test
    void itDoesNotMatterHowTheBytesAreCut() throws IOException {
        Random random = new Random(SEED);
        String text = "a\u202Eb\u00e9\u2013\u061C\u0627\uD83D\uDE80\u001b[1mc\u2066";
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        for (int n = 0; n < 200; n++) {
            ByteArrayOutputStream terminal = new ByteArrayOutputStream();
            TerminalOutputStream out = new TerminalOutputStream(terminal);
            for (int k = 0; k < bytes.length;) {
                int length = Math.min(bytes.length - k, random.nextInt(4));
                out.write(bytes, k, length);
                k += length;
            }
            assertEquals("a?b\u00e9\u2013?\u0627\uD83D\uDE80\u001b[1mc?", terminal.toString(StandardCharsets.UTF_8),
                "seed " + SEED + ", round " + n);
        }
    }

    /** Bytes that are no UTF-8 are the terminal's affair, but none is lost. */
    @Test
    void brokenCharactersPass() throws IOException {
        byte[] broken = {(byte) 0xe2, (byte) 0x80, 'x', (byte) 0xc2, 'y', (byte) 0xff, '\n'};
        ByteArrayOutputStream terminal = new ByteArrayOutputStream();
        new TerminalOutputStream(terminal).write(broken);
        assertEquals(new String(broken, StandardCharsets.ISO_8859_1), terminal.toString(StandardCharsets.ISO_8859_1));
    }
}
