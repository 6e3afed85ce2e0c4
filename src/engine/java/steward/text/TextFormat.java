package steward.text;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Format of numbers and texts for commands, the same in every locale. */
public final class TextFormat {

    public static final double NANOS_PER_MS = 1e6;
    private static final String DOTS = "...";
    private static final double MINUTE = 60;
    private static final int ROUND_SECONDS = 10;

    private TextFormat() { }

    /** A number for a table: at most {@code decimals} decimals, no trailing zeros, no negative zero. */
    public static String number(double value, int decimals) {
        if (value == Math.rint(value) && Math.abs(value) < 1e15) {
            return Long.toString((long) value);
        }
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            return Double.toString(value);
        }
        BigDecimal rounded = BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_EVEN);
        String text = rounded.stripTrailingZeros().toPlainString();
        return text.length() <= 16 ? text : Double.toString(value);
    }

    /** A number with exactly {@code decimals} decimals; NaN as a dash, an infinite one in words. */
    public static String fixed(double value, int decimals) {
        if (Double.isInfinite(value)) {
            return Double.toString(value);
        }
        return Double.isNaN(value) ? "-" : BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_EVEN)
            .toPlainString();
    }

    /** Nanoseconds as milliseconds with two decimals. */
    public static String ms(long nanos) {
        return fixed(nanos / NANOS_PER_MS, 2);
    }

    /** {@code 1 turn}, {@code 2 turns}. */
    public static String count(long number, String what) {
        return number + " " + what + (number == 1 ? "" : "s");
    }

    /** A length of time that is only known roughly: {@code about 40 seconds}, {@code about 3 minutes}. */
    public static String about(double seconds) {
        double minutes = seconds / MINUTE;
        return seconds < MINUTE - ROUND_SECONDS / 2.0
            ? "about " + count(Math.max(1, Math.round(seconds < ROUND_SECONDS ? seconds
                : ROUND_SECONDS * Math.rint(seconds / ROUND_SECONDS))), "second")
            : minutes < MINUTE ? "about " + count(Math.round(minutes), "minute")
            : "about " + count(Math.round(minutes / MINUTE), "hour");
    }

    /** Right-aligned: padded with blanks on the left. */
    public static String right(String text, int width) {
        return " ".repeat(Math.max(0, width - text.length())) + text;
    }

    /** Left-aligned: padded with blanks on the right. */
    public static String left(String text, int width) {
        return text + " ".repeat(Math.max(0, width - text.length()));
    }

    /** At most {@code width} characters; a longer text ends in "...". */
    public static String shorten(String text, int width) {
        return text.length() <= width ? text : beginning(text, width - DOTS.length());
    }

    /** The first {@code most} characters, then "..." if there are more. No surrogate pair is split. */
    public static String beginning(String text, int most) {
        if (text.length() <= most) {
            return text;
        }
        boolean half = most > 0 && Character.isHighSurrogate(text.charAt(most - 1))
            && Character.isLowSurrogate(text.charAt(most));
        return text.substring(0, half ? most - 1 : most) + DOTS;
    }

    /**
     * Wraps a line between items, so that no line is wider unless a single item is.
     *
     * @param separator between items, two characters; its non-blank part stays at the end of a line
     * @param indent    starts every line but the first
     */
    public static String wrap(String items, String separator, int width, String indent) {
        StringBuilder text = new StringBuilder();
        int used = 0;
        for (String item : items.split(separator)) {
            if (used > 0 && used + separator.length() + item.length() >= width) {
                text.append(separator.strip()).append('\n').append(indent).append(item);
                used = indent.length() + item.length();
            } else {
                text.append(used > 0 ? separator : "").append(item);
                used += (used > 0 ? separator.length() : 0) + item.length();
            }
        }
        return text.toString();
    }

    /**
     * Text from a bot or a file made safe for a terminal: characters other than line feed and tab that cannot be seen
     * are escaped, as {@code \\u202E}. The joiners of emoji and scripts stay.
     */
    public static String plain(String text) {
        return escaped(text, "\n\t\u200C\u200D");
    }

    /** A text with escapes, such as {@code \\u202E}, in place of all characters that cannot be seen, but for some. */
    public static String escaped(String text, String kept) {
        StringBuilder seen = null;
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            boolean hidden = isUnseen(c) && kept.indexOf(c) < 0;
            if (hidden && seen == null) {
                seen = new StringBuilder(text.substring(0, k));
            }
            if (seen != null) {
                seen.append(hidden ? escape(c) : String.valueOf(c));
            }
        }
        return seen == null ? text : seen.toString();
    }

    /** Returns a character as JSON and Java write it, such as {@code \\u202E}. */
    public static String escape(char c) {
        return switch (c) {
            case '\n' -> "\\n";
            case '\r' -> "\\r";
            case '\t' -> "\\t";
            default -> String.format("\\u%04X", (int) c);
        };
    }

    /**
     * True if a character cannot be seen: {@link #isUnsafe}, or one of the classes Cf, Zl and Zp of Unicode, as the
     * byte order mark, spaces without width and the separators of lines.
     */
    public static boolean isUnseen(char c) {
        int type = c < ' ' || c > '~' ? Character.getType(c) : Character.OTHER_SYMBOL;
        return isUnsafe(c) || type == Character.FORMAT || type == Character.LINE_SEPARATOR
            || type == Character.PARAGRAPH_SEPARATOR;
    }

    /**
     * True if a character steers a terminal or shows a text otherwise than it is written: C0 and C1 controls, and the
     * marks, embeddings, overrides and isolates of the bidirectional algorithm (Unicode Standard Annex 9, section 2).
     */
    public static boolean isUnsafe(char c) {
        return Character.isISOControl(c) || c == '\u061C' || c == '\u200E' || c == '\u200F'
            || c >= '\u202A' && c <= '\u202E' || c >= '\u2066' && c <= '\u2069';
    }
}
