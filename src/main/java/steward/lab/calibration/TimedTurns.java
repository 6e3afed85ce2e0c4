package steward.lab.calibration;

/** So many turns that are timed together, long enough for a clock. */
interface TimedTurns {

    /** Is not timed. */
    default void prepare() {
    }

    /** Plays the turns. */
    void run();

    /** How many turns it has. */
    int turns();
}
