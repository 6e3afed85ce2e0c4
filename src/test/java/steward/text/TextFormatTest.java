package steward.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Numbers and texts as people read them. */
class TextFormatTest {

    @Test
    void numbersAreRoundedAndLoseTheirZeros() {
        assertEquals("5", TextFormat.number(5.0, 3));
        assertEquals("0", TextFormat.number(-0.0, 3));
        assertEquals("-2.5", TextFormat.number(-2.5, 3));
        assertEquals("0.333", TextFormat.number(1 / 3.0, 3));
        assertEquals("0", TextFormat.number(1e-9, 3));
        assertEquals("Infinity", TextFormat.number(Double.POSITIVE_INFINITY, 3));
        assertEquals("0.10", TextFormat.fixed(0.1, 2));
        assertEquals("-", TextFormat.fixed(Double.NaN, 2));
        assertEquals("12.35", TextFormat.ms(12_345_678));
    }

    @Test
    void nothingThatABotWroteSteersTheTerminal() {
        assertEquals("?[2Jred?[0m\nnext\tline", TextFormat.plain("\u001b[2Jred\u001b[0m\nnext\tline"));
        assertEquals("ä", TextFormat.plain("ä"));
    }

    @Test
    void linesBreakBetweenItems() {
        assertEquals("one, two,\n    three", TextFormat.wrap("one, two, three", ", ", 14, "    "));
        assertEquals("one  two", TextFormat.wrap("one  two", "  ", 14, "    "));
        assertEquals("alongitemthatfitsnowhere,\n  b", TextFormat.wrap("alongitemthatfitsnowhere, b", ", ", 10, "  "));
    }

    @Test
    void aShortenedTextFitsItsColumn() {
        assertEquals("veteran", TextFormat.shorten("veteran", 7));
        assertEquals("vet...", TextFormat.shorten("veteran", 6));
        assertEquals("", TextFormat.shorten("", 0));
    }

    @Test
    void aBeginningHasSoManyCharactersOfTheText() {
        assertEquals("veteran", TextFormat.beginning("veteran", 7));
        assertEquals("vetera...", TextFormat.beginning("veteran", 6));
        assertEquals("...", TextFormat.beginning("veteran", 0));
    }

    @Test
    void noSurrogatePairIsCutInHalf() {
        String faces = "a\uD83D\uDE00\uD83D\uDE00b";
        assertEquals("a...", TextFormat.beginning(faces, 2));
        assertEquals("a\uD83D\uDE00...", TextFormat.beginning(faces, 3));
        assertEquals("a\uD83D\uDE00...", TextFormat.beginning(faces, 4));
        assertEquals("a\uD83D\uDE00\uD83D\uDE00...", TextFormat.beginning(faces, 5));
        assertEquals(faces, TextFormat.beginning(faces, 6));
        assertEquals("a...", TextFormat.shorten(faces, 5));
        assertEquals("half \uD83D...", TextFormat.beginning("half \uD83D of one", 6));
    }
}
