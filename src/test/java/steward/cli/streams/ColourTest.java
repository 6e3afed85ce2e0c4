package steward.cli.streams;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Colours, and where there are none. */
class ColourTest {

    @Test
    void onATerminal() {
        assertEquals("\u001b[31mfailed\u001b[0m", Colour.of(true, null, "xterm").bad("failed"));
        assertEquals("\u001b[32mverified\u001b[0m", Colour.of(true, "", null).good("verified"));
    }

    @Test
    void notWhereNobodyWantsThem() {
        assertEquals("failed", Colour.of(true, "1", "xterm").bad("failed"));
        assertEquals("failed", Colour.of(true, "false", "xterm").bad("failed"), "any value counts");
        assertEquals("failed", Colour.of(false, null, "xterm").bad("failed"));
        assertEquals("failed", Colour.of(true, null, "dumb").bad("failed"));
    }
}
