package steward.lab.timing;

/** Some turns that are timed together, long enough for a clock. */
public interface TimedTurns {

    /** Prepares the next turns; not timed. */
    default void prepare() { }

    /** Plays the turns that were prepared. */
    void run();

    /** Returns how many turns the last {@link #run} has played. */
    int turns();

    /** After how many runs all different turns have been played once: a measurement consists of whole cycles. */
    default int cycle() {
        return 1;
    }
}
