package steward.lab.trial;

/**
 * One row of the stability table: a situation at the edge of what numbers can do, and what is demanded there. A case is
 * stateless and deterministic: the same rung and size see the same.
 */
public interface StabilityCase {

    /** A few words, unique among the cases. */
    String name();

    /** What is demanded, and of which rungs. */
    String demand();

    /**
     * Tries it. What goes wrong in the engine is seen as a failure or thrown.
     *
     * @param progress told of cases that take minutes in their long version
     */
    Finding run(Rung rung, RunLength size, Progress progress);
}
