package steward.lab.timing;

/**
 * A measured stretch of turns.
 *
 * @param nanos a turn's CPU time, in nanoseconds
 * @param bytes a turn's allocation; NaN where the JVM does not tell it
 */
public record Stretch(double nanos, double bytes) { }
