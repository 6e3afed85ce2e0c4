package steward.lab.chart;

import java.awt.Color;
import java.util.List;

/**
 * Colours of a picture: for rungs those of Okabe and Ito (2008), which people with colour vision deficiencies can tell
 * apart. Dark pages have lighter ones.
 *
 * @param isDark of a picture for dark pages
 * @param faint  of the lines from marks to their names
 * @param steps  of the rungs with steps
 * @param events of the rungs with exact times
 */
public record ChartColours(boolean isDark, Color background, Color ink, Color faint, Color grid, Color steps,
                           Color events) {

    /** For light pages. */
    public static final ChartColours LIGHT = new ChartColours(false, Color.WHITE, new Color(0x24292F),
        new Color(0x8C959F), new Color(0xDDE1E5), new Color(0x0072B2), new Color(0xC04A00));
    /** For the background that code hosts show pages on at night. */
    public static final ChartColours DARK = new ChartColours(true, new Color(0x0D1117), new Color(0xE6EDF3),
        new Color(0x768390), new Color(0x30363D), new Color(0x56B4E9), new Color(0xFF9B54));

    public static List<ChartColours> both() {
        return List.of(LIGHT, DARK);
    }
}
