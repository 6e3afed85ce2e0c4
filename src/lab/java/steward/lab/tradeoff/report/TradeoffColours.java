package steward.lab.tradeoff.report;

import java.awt.Color;

/**
 * The colours of a picture: blue and orange after Okabe and Ito (2008), which can be told apart with colour vision
 * deficiencies, lighter ones for dark pages.
 *
 * @param faint  of the lines from marks to their names
 * @param steps  of the rungs with steps
 * @param events of the rungs with exact times
 */
record TradeoffColours(Color background, Color ink, Color faint, Color grid, Color steps, Color events) {

    static final TradeoffColours LIGHT = new TradeoffColours(Color.WHITE, new Color(0x24292F),
        new Color(0x8C959F), new Color(0xDDE1E5), new Color(0x0072B2), new Color(0xC04A00));
    /** On the background that code hosts show pages on at night. */
    static final TradeoffColours DARK = new TradeoffColours(new Color(0x0D1117), new Color(0xE6EDF3),
        new Color(0x768390), new Color(0x30363D), new Color(0x56B4E9), new Color(0xFF9B54));
}
