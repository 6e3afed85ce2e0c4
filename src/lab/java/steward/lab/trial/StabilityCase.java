package steward.lab.trial;

/**
 * One row of the stability table: a situation at the limits of floating point, and what is demanded there. A case is
 * stateless and deterministic: the same rung and size give the same result.
 */
public interface StabilityCase {

    /** A few words, unique among the cases. */
    String name();

    /** Describes the demand, and on which rungs it stands. */
    String demand();

    /**
     * Runs the case. An error of the engine is reported as a failure or thrown.
     *
     * @param progress called by cases that take minutes in their long version
     */
    Finding run(Rung rung, RunLength size, Progress progress);
}
