package steward.lab.trial;

import java.util.Locale;

/** Amount of work of a stability case: for a test suite, for a table, or as much as the case can do. */
public enum RunLength {
    /** Seconds for all cases together. */
    SMALL,
    /** Minutes. */
    NORMAL,
    /** Hours. */
    LONG;

    /** The length of a word, in lower case. */
    public static RunLength of(String word) {
        return valueOf(word.toUpperCase(Locale.ROOT));
    }

    /** The count for this run length. */
    public int pick(int small, int normal, int all) {
        return this == SMALL ? small : this == NORMAL ? normal : all;
    }
}
