package steward.lab.timing;

/**
 * Measured time and allocation per unit of work.
 *
 * @param nanos a unit's time by the clock of the measurement, in nanoseconds
 * @param bytes a unit's allocation; NaN where nobody tells
 */
public record Stretch(double nanos, double bytes) { }
