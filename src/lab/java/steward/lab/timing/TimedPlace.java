package steward.lab.timing;

import java.util.concurrent.TimeUnit;

/**
 * Place where one kind of work is timed, in this JVM or another: warmed up until times are steady, then measured in
 * rounds.
 */
@FunctionalInterface
public interface TimedPlace extends AutoCloseable {

    /** Nanoseconds of a second. */
    double NANOS = TimeUnit.SECONDS.toNanos(1);

    /**
     * Works without keeping times until these are steady; by default for the least time, by the wall clock.
     *
     * @param least seconds, at least
     * @param most  seconds after which it is given up
     */
    default void warmUp(double least, double most) throws Exception {
        for (long begin = System.nanoTime(); System.nanoTime() - begin < least * NANOS;) {
            round(0);
        }
    }

    /** Measures at least so many seconds, and every different piece of work once in any case. */
    Stretch round(double least) throws Exception;

    @Override
    default void close() { }
}
