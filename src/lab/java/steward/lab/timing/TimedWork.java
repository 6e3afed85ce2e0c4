package steward.lab.timing;

/** Interface of work that is timed piece by piece; a piece is long enough for a clock. */
@FunctionalInterface
public interface TimedWork {

    /** Prepares the next piece; not timed. */
    default void prepare() { }

    /** Does a piece and returns how many units it had, for instance turns. */
    long run() throws Exception;

    /** After how many pieces all different ones have been done once: a round consists of whole cycles. */
    default int cycle() {
        return 1;
    }
}
