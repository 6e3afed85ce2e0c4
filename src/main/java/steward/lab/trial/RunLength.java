package steward.lab.trial;

/** How much work a case is given: what a test suite can wait for, a table, or everything the case can be asked. */
public enum RunLength {
    /** Seconds for all cases together. */
    SMALL,
    /** Minutes. */
    NORMAL,
    /** Hours. */
    LONG;

    /** One of three counts. */
    public int pick(int small, int normal, int all) {
        return this == SMALL ? small : this == NORMAL ? normal : all;
    }
}
