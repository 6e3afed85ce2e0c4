package steward.bench;

/**
 * One way to do a piece of work, to be measured against others.
 *
 * @param name  for people
 * @param clock by which it is measured
 * @param work  a piece of it, some milliseconds long
 */
public record Contender(String name, Clock clock, Work work) {

    /** What counts as time. */
    public enum Clock {
        /** The CPU time of the calling thread, which works alone. */
        THREAD,
        /** The CPU time of the whole JVM, because other threads work too. */
        JVM,
        /** What passes: threads side by side, and what waits for other programs counts as well. */
        WALL
    }

    /** Some work. */
    public interface Work {

        /** Does a piece and returns how many units it had. */
        long run() throws Exception;
    }

    /** Work of the calling thread, or of others too: by CPU time. */
    public Contender(String name, boolean threads, Work work) {
        this(name, threads ? Clock.JVM : Clock.THREAD, work);
    }

    /** Work of the calling thread alone. */
    public Contender(String name, Work work) {
        this(name, Clock.THREAD, work);
    }
}
