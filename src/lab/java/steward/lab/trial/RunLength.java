package steward.lab.trial;

/** Amount of work of a stability case: for a test suite, for a table, or as much as the case can do. */
public enum RunLength {
    /** Seconds for all cases together. */
    SMALL,
    /** Minutes. */
    NORMAL,
    /** Hours. */
    LONG;

    /** The count for this run length. */
    public int pick(int small, int normal, int all) {
        return this == SMALL ? small : this == NORMAL ? normal : all;
    }
}
