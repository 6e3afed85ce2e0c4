package steward.lab.bench;

/**
 * One way to do a piece of work, to be compared with others.
 *
 * @param work a piece of work, some milliseconds long
 */
public record Contender(String name, Clock clock, Work work) {

    /** Clock that is counted. */
    public enum Clock {
        /** The CPU time of the calling thread, which works alone. */
        THREAD,
        /** The CPU time of the whole JVM, because other threads work as well. */
        JVM,
        /** Wall-clock time: for threads side by side, and where waiting for other programs counts as well. */
        WALL
    }

    /** Some work. */
    public interface Work {

        /** Does a piece of work and returns how many units it had. */
        long run() throws Exception;
    }

    /** Work of the calling thread, or of other threads too: measured by CPU time. */
    public Contender(String name, boolean threads, Work work) {
        this(name, threads ? Clock.JVM : Clock.THREAD, work);
    }

    /** Work of the calling thread alone. */
    public Contender(String name, Work work) {
        this(name, Clock.THREAD, work);
    }
}
