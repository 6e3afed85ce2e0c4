package steward.lab.trial;

import java.util.Arrays;
import java.util.Locale;

/** Amount of work of a stability case: for a test suite, for a table, or as much as the case can do. */
public enum RunLength {
    /** Seconds for all cases together. */
    SMALL,
    /** Minutes. */
    NORMAL,
    /** Hours. */
    LONG;

    /** The length of a word, in lower case. @throws IllegalArgumentException for another word */
    public static RunLength of(String word) {
        return Arrays.stream(values()).filter(each -> each.name().toLowerCase(Locale.ROOT).equals(word)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("length: found '" + word
                + "', expected small, normal or long"));
    }

    /** The count for this run length. */
    public int pick(int small, int normal, int all) {
        return this == SMALL ? small : this == NORMAL ? normal : all;
    }
}
