package steward.machines.broker;

/** Admission of workers: who connects, and who is handed jobs. Called by the broker's threads, which must not wait. */
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
