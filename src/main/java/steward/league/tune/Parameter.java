package steward.league.tune;

import java.util.Arrays;
import java.util.List;
import steward.text.TextFormat;

/**
 * A tunable parameter in a bot's command, such as {@code {depth:1..9}}. {@code {name:low..high}} is a real number if
 * the bounds have decimal points, otherwise a whole one; {@code {name:one|other|third}} is a choice. {@code @start}
 * before the closing brace gives the start of tuning, by default the middle or the first choice. All are moved on a
 * scale from 0 to 1.
 *
 * @param low     the lowest value; of a choice 0
 * @param high    the highest; of a choice the number of the last
 * @param whole   whether it is a whole number
 * @param choices the words of a choice, or none
 * @param start   where it begins, on the scale
 */
public record Parameter(String name, double low, double high, boolean whole, List<String> choices, double start) {

    private static final double HALF = 0.5;
    private static final int DECIMALS = 6;

    public Parameter {
        choices = List.copyOf(choices);
    }

    /**
     * Reads what stands between the braces.
     *
     * @throws IllegalArgumentException if it is none; the message says what was found and what was expected
     */
    public static Parameter parse(String text) {
        int colon = text.indexOf(':');
        String name = colon < 0 ? text : text.substring(0, colon);
        if (colon < 0 || !name.matches("[A-Za-z_][A-Za-z0-9_-]*")) {
            throw new IllegalArgumentException("found '{" + text + "}', expected {name:low..high}, {name:one|other}, "
                + "or {name:low..high@start}");
        }
        String rest = text.substring(colon + 1);
        int at = rest.lastIndexOf('@');
        String start = at < 0 ? null : rest.substring(at + 1);
        String range = at < 0 ? rest : rest.substring(0, at);
        return range.contains("|") ? choice(text, name, range, start) : number(text, name, range, start);
    }

    private static Parameter choice(String text, String name, String range, String start) {
        List<String> choices = Arrays.asList(range.split("\\|", -1));
        if (choices.contains("") || choices.stream().distinct().count() < choices.size()) {
            throw new IllegalArgumentException("{" + text + "}: found '" + range + "', expected different words");
        }
        int first = start == null ? 0 : choices.indexOf(start);
        if (first < 0) {
            throw new IllegalArgumentException("{" + text + "}: found the start '" + start + "', expected one of "
                + String.join(", ", choices));
        }
        return new Parameter(name, 0, choices.size() - 1, true, choices, (first + HALF) / choices.size());
    }

    private static Parameter number(String text, String name, String range, String start) {
        int dots = range.indexOf("..");
        double low = dots < 0 ? Double.NaN : value(range.substring(0, dots));
        double high = dots < 0 ? Double.NaN : value(range.substring(dots + 2));
        if (Double.isNaN(low) || Double.isNaN(high)) {
            throw new IllegalArgumentException("{" + text + "}: found the range '" + range
                + "', expected two numbers with '..' between them, or words with '|' between them");
        }
        if (!(low < high)) {
            throw new IllegalArgumentException("{" + text + "}: found an empty range, expected the lower number first");
        }
        boolean whole = isWhole(range.substring(0, dots)) && isWhole(range.substring(dots + 2));
        Parameter parameter = new Parameter(name, low, high, whole, List.of(), HALF);
        if (start == null) {
            return parameter;
        }
        double first = value(start);
        if (!(first >= low && first <= high) || whole && !isWhole(start)) {
            throw new IllegalArgumentException("{" + text + "}: found the start '" + start + "', expected a number "
                + "from " + range.replace("..", " to "));
        }
        return new Parameter(name, low, high, whole, List.of(), parameter.place(first));
    }

    private static boolean isWhole(String number) {
        return number.matches("[+-]?[0-9]+");
    }

    private static double value(String number) {
        return number.matches("[+-]?([0-9]+(\\.[0-9]+)?|\\.[0-9]+)([eE][+-]?[0-9]+)?") ? Double.parseDouble(number)
            : Double.NaN;
    }

    private double place(double value) {
        return whole ? (value - low + HALF) / (high - low + 1) : (value - low) / (high - low);
    }

    /** The value at a place of the scale, as it stands in a command. */
    public String value(double place) {
        double inside = Math.max(0, Math.min(1, place));
        if (!whole) {
            return TextFormat.number(low + inside * (high - low), DECIMALS);
        }
        long number = (long) Math.min(high, Math.floor(low + inside * (high - low + 1)));
        return choices.isEmpty() ? Long.toString(number) : choices.get((int) number);
    }

    /** The least distance on the scale within which another value is found. */
    double step() {
        return whole ? HALF / (high - low + 1) : 0;
    }
}
