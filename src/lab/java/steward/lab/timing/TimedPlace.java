package steward.lab.timing;

/** Place where one kind of turns is timed: a JVM of its own, or this one. */
public interface TimedPlace extends AutoCloseable {

    /**
     * Runs without keeping times until these are steady.
     *
     * @param least seconds of CPU, at least
     * @param most  seconds of CPU after which it is given up
     * @return whether they have become steady
     */
    boolean warmUp(double least, double most);

    /** Measures at least so many seconds of CPU, and all states once in any case. */
    Stretch round(double least);

    @Override
    default void close() { }
}
