package steward.bot;

/**
 * A bot that runs inside this JVM and reads and answers the same lines as a bot program. One instance plays one match;
 * the methods are called by one thread at a time.
 */
public interface Bot {

    /**
     * The first line of a match.
     *
     * @param line the setup frame, without line end
     */
    void setup(String line);

    /**
     * One turn.
     *
     * @param line the turn frame, without line end
     * @return the answer, without line end; several lines (protocols that want them) are separated by {@code '\n'}
     */
    String turn(String line);

    /**
     * The last line of a match.
     *
     * @param line the end frame, without line end
     */
    default void end(String line) { }
}
