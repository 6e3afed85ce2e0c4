package steward.bench;

/**
 * One measured line.
 *
 * @param section   what was measured
 * @param name      which way
 * @param unit      what is counted
 * @param perSecond units per second, of CPU time or of the wall clock as the section says
 * @param ratio     how many times the first line of its group, NaN where there is nothing to compare
 * @param bytes     allocated per unit, NaN where that was not counted
 * @param note      anything else, may be empty
 */
public record Row(String section, String name, String unit, double perSecond, double ratio, double bytes,
                  String note) {

    private static final double NANOS = 1e9;

    /** Nanoseconds per unit. */
    public double nanos() {
        return NANOS / perSecond;
    }
}
