package steward.cli.replay;

import steward.cli.streams.Json;
import steward.text.TextFormat;

/** Headings as text: a replay has radians plus any number of whole turns; people see degrees in [0, 360). */
final class HeadingText {

    private static final String FIELD = "heading";
    private static final double FULL_TURN = 360;

    /** True if a field of a body is a heading. */
    static boolean is(Object field) {
        return FIELD.equals(field);
    }

    /** The title of a field: its name, with the unit of a heading. */
    static String title(Object field) {
        return is(field) ? FIELD + "\u00b0" : String.valueOf(field);
    }

    /** Degrees, or {@code -} while there is no heading. */
    static String of(Object radians, int decimals) {
        double turned = Math.toDegrees(Json.number(radians)) % FULL_TURN;
        double degrees = turned < 0 ? turned + FULL_TURN : turned;
        String text = TextFormat.number(degrees, decimals);
        return Double.isNaN(degrees) ? "-" : text.equals("360") ? "0" : text;
    }
}
