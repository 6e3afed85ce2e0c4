package steward.lab.trial;

/**
 * One row of the stability table: a situation at the limits of floating point, and the requirement for its result. A
 * case is stateless and deterministic: the same rung and size give the same result.
 */
public abstract class StabilityCase {

    private final String name;
    private final String demand;

    /**
     * @param name   a few words, unique among the cases
     * @param demand describes the demand, and on which rungs it stands
     */
    protected StabilityCase(String name, String demand) {
        this.name = name;
        this.demand = demand;
    }

    public final String name() {
        return name;
    }

    public final String demand() {
        return demand;
    }

    /** Runs the case. An error of the engine is reported as a failure or thrown. */
    public abstract Finding run(Rung rung, RunLength size);
}
