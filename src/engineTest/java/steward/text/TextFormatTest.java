package steward.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Numbers and texts as people read them. */
class TextFormatTest {

    @Test
    void aRoughTimeHasOneUnit() {
        assertEquals("about 1 second", TextFormat.about(0.2));
        assertEquals("about 7 seconds", TextFormat.about(7.4));
        assertEquals("about 50 seconds", TextFormat.about(54));
        assertEquals("about 1 minute", TextFormat.about(55));
        assertEquals("about 10 minutes", TextFormat.about(613));
        assertEquals("about 2 hours", TextFormat.about(7241));
    }

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
        assertEquals("\\u001B[2Jred\\u001B[0m\nnext\tline", TextFormat.plain("\u001b[2Jred\u001b[0m\nnext\tline"));
        assertEquals("ä", TextFormat.plain("ä"));
    }

    /** The list is that of Unicode Standard Annex 9, table "Explicit formatting characters", and the C1 controls. */
    @Test
    void nothingThatABotWroteReordersOrHidesText() {
        String reordering = "\u202A\u202B\u202C\u202D\u202E\u2066\u2067\u2068\u2069\u200E\u200F\u061C";
        assertEquals("a\\u202A\\u202B\\u202C\\u202D\\u202E\\u2066\\u2067\\u2068\\u2069\\u200E\\u200F\\u061Cb",
            TextFormat.plain("a" + reordering + "b"));
        assertEquals("\\u0085\\u009B\\u007F\\uFEFF\\u2028", TextFormat.plain("\u0085\u009B\u007F\uFEFF\u2028"));
        assertEquals("\u05D0 \u0627 \u200D", TextFormat.plain("\u05D0 \u0627 \u200D"), "letters stay");
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
