package steward.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import steward.text.Utf8Text.NotUtf8Exception;

/** Texts that are not UTF-8: lines end with a line feed, and each character has one column. */
class Utf8TextTest {

    private static byte[] latin(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    private static String refused(byte... bytes) {
        return assertThrows(NotUtf8Exception.class, () -> Utf8Text.decode(bytes, "f", "a text in UTF-8")).getMessage();
    }

    private static String at(String place, String found) {
        return "f:" + place + ": found the byte 0x" + found + ", which is not UTF-8 here, expected a text in UTF-8";
    }

    @Test
    void aTextInUtf8IsDecoded() throws NotUtf8Exception {
        assertEquals("é\n\uD83D\uDE00", Utf8Text.decode("é\n\uD83D\uDE00".getBytes(StandardCharsets.UTF_8), "f", "x"));
    }

    @Test
    void theFirstWrongByteIsNamedByLineAndColumn() {
        assertEquals(at("1:1", "E9"), refused(latin("é")));
        assertEquals(at("2:3", "E9"), refused(latin("abc\nabé")));
        assertEquals(at("1:4", "C3"), refused(latin("abc\u00C3")), "cut off within a character");
        assertEquals(at("1:1", "C0"), refused(latin("\u00C0\u0080")), "NUL in two bytes");
    }

    @Test
    void aColumnIsACharacterAndNotAByte() {
        byte[] bytes = "é\uD83D\uDE00x?".getBytes(StandardCharsets.UTF_8);
        bytes[bytes.length - 1] = (byte) 0xFF;
        assertEquals(at("1:4", "FF"), refused(bytes));
    }

    /** Longer than what is decoded at once, with a character across the border. */
    @Test
    void placesAreRightInLongTexts() {
        String line = "x".repeat(8190) + "éé\n";
        byte[] bytes = (line + line + "ab?").getBytes(StandardCharsets.UTF_8);
        bytes[bytes.length - 1] = (byte) 0xA0;
        assertEquals(at("3:3", "A0"), refused(bytes));
    }
}
