package steward.machines.broker;

/** Names of the broker's queues and of message properties. */
final class Queues {

    /** Games to be played; whoever is free takes one. */
    static final String JOBS = "jobs";
    /** Queue of the workers' messages. */
    static final String REPORTS = "reports";
    /** Before a worker's name: what only it is told. */
    static final String TO = "to.";
    /** The id of a job. */
    static final String JOB = "job";
    /** Before a bundle's hash: that a job needs it. */
    static final String NEEDS = "b_";

    /** Returns the selector of jobs that do not need any of these bundles; {@code null} for all jobs. */
    static String without(Iterable<String> bundles) {
        StringBuilder filter = new StringBuilder();
        for (String bundle : bundles) {
            filter.append(filter.length() == 0 ? "" : " AND ").append(NEEDS).append(bundle).append(" IS NULL");
        }
        return filter.length() == 0 ? null : filter.toString();
    }
}
