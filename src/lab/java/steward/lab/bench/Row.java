package steward.lab.bench;

import steward.lab.timing.TimedPlace;

/**
 * Row of the bench's table: one measured contender.
 *
 * @param perSecond units per second, of CPU time or of the wall clock as the section says
 * @param ratio     the speed relative to the first row of its group, NaN where there is nothing to compare
 * @param bytes     allocated per unit, NaN where it was not measured
 * @param note      further remarks, may be empty
 */
public record Row(String section, String name, String unit, double perSecond, double ratio, double bytes,
                  String note) {

    /** Nanoseconds per unit. */
    public double nanos() {
        return TimedPlace.NANOS / perSecond;
    }

    /** Returns the row with a further remark, which may be empty. */
    public Row remark(String more) {
        return more.isEmpty() ? this
            : new Row(section, name, unit, perSecond, ratio, bytes, note.isEmpty() ? more : note + ", " + more);
    }
}
