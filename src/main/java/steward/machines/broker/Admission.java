package steward.machines.broker;

/**
 * Interface that decides which workers may connect and which are handed jobs. The broker's threads call it, so it must
 * not block.
 */
public interface Admission {

    /** True if a worker of a name has this secret and may play. */
    boolean admits(String worker, String secret);

    /**
     * Takes in a worker that is not known yet.
     *
     * @param secret     its own
     * @param invitation the secret of an invitation
     * @return why not, or {@code null} if it may play now
     */
    default String enrol(String worker, String secret, String invitation) {
        return "the invitation is unknown";
    }

    /** True if a worker that has so many jobs may be handed another. */
    default boolean mayTake(String worker, int jobs) {
        return true;
    }

    /** Notes that a worker has been handed a job. */
    default void took(String worker) { }
}
