package steward.cli.league;

import steward.text.TextFormat;

/** File sizes as text for people. */
final class Sizes {

    private static final double KILO = 1000;

    /** Such as {@code 312 kB}. */
    static String text(long bytes) {
        return bytes < KILO ? bytes + " B" : bytes < KILO * KILO ? TextFormat.number(bytes / KILO, 0) + " kB"
            : bytes < KILO * KILO * KILO ? TextFormat.number(bytes / KILO / KILO, 1) + " MB"
            : TextFormat.number(bytes / KILO / KILO / KILO, 2) + " GB";
    }
}
