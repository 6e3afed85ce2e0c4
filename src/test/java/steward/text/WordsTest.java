package steward.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Numbers and texts as people read them. */
class WordsTest {

    @Test
    void numbersAreRoundedAndLoseTheirZeros() {
        assertEquals("5", Words.number(5.0, 3));
        assertEquals("0", Words.number(-0.0, 3));
        assertEquals("-2.5", Words.number(-2.5, 3));
        assertEquals("0.333", Words.number(1 / 3.0, 3));
        assertEquals("0", Words.number(1e-9, 3));
        assertEquals("Infinity", Words.number(Double.POSITIVE_INFINITY, 3));
        assertEquals("0.10", Words.fixed(0.1, 2));
        assertEquals("-", Words.fixed(Double.NaN, 2));
        assertEquals("12.35", Words.ms(12_345_678));
    }

    @Test
    void nothingThatABotWroteSteersTheTerminal() {
        assertEquals("?[2Jred?[0m\nnext\tline", Words.plain("\u001b[2Jred\u001b[0m\nnext\tline"));
        assertEquals("ä", Words.plain("ä"));
    }

    @Test
    void linesBreakBetweenItems() {
        assertEquals("one, two,\n    three", Words.wrap("one, two, three", ", ", 14, "    "));
        assertEquals("one  two", Words.wrap("one  two", "  ", 14, "    "));
        assertEquals("alongitemthatfitsnowhere,\n  b", Words.wrap("alongitemthatfitsnowhere, b", ", ", 10, "  "));
    }
}
