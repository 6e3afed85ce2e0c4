package steward.machines.broker;

/** Decides who may connect. Called by the broker's threads. */
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
}
