package steward.bench;

/**
 * One way to do a piece of work, to be measured against others.
 *
 * @param name    for people
 * @param threads whether other threads than the calling one work too: then the CPU time of the whole JVM counts
 * @param work    a piece of it, some milliseconds long
 */
public record Contender(String name, boolean threads, Work work) {

    /** Some work. */
    public interface Work {

        /** Does a piece and returns how many units it had. */
        long run() throws Exception;
    }

    /** Work of the calling thread alone. */
    public Contender(String name, Work work) {
        this(name, false, work);
    }
}
