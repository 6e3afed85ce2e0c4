package steward.scene.json;

import java.util.Collection;
import java.util.Locale;
import java.util.stream.Collectors;
import steward.text.NearestName;

/** Wording of numbers, ranges and choices in errors and plans. */
public final class Wording {

    private Wording() { }

    /** The shortest usual notation: 120, 0.15, 1e-5. */
    public static String number(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e9) {
            return Long.toString((long) value);
        }
        return Double.toString(value).replace(".0E", "E").toLowerCase(Locale.ROOT);
    }

    /** A range of finite numbers, its bounds included. */
    static String range(double low, double high) {
        boolean hasLow = low > Double.NEGATIVE_INFINITY;
        boolean hasHigh = high < Double.POSITIVE_INFINITY;
        if (hasLow && hasHigh) {
            return "a number " + number(low) + ".." + number(high);
        }
        if (hasLow) {
            return "a number of at least " + number(low);
        }
        return hasHigh ? "a number of at most " + number(high) : "a finite number";
    }

    /** The allowed words, and the nearest of them to a word that is not allowed. */
    public static String choice(String word, Collection<String> known) {
        return oneOf(known) + NearestName.question(word, known, "\"");
    }

    /** The allowed words. */
    public static String oneOf(Collection<String> known) {
        String list = known.stream().map(name -> '"' + name + '"').collect(Collectors.joining(", "));
        return known.size() == 1 ? list : "one of " + list;
    }
}
