package steward.lab.calibration;

/** Some turns that are timed together, long enough for a clock. */
interface TimedTurns {

    /** Prepares the turns; not timed. */
    default void prepare() {
    }

    /** Plays the turns. */
    void run();

    /** How many turns there are. */
    int turns();
}
