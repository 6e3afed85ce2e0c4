package steward.lab.stability;

import steward.lab.trial.Finding;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;

/**
 * Result of a case on a rung, with its time.
 *
 * @param seconds how long it took
 */
public record StabilityRow(String name, String demand, String rung, Finding seen, double seconds) {

    private static final double NANOS = 1e9;

    /** Runs a case on a rung. An exception that the case did not expect is a failure. */
    public static StabilityRow of(StabilityCase each, Rung rung, RunLength size) {
        long start = System.nanoTime();
        Finding seen;
        try {
            seen = each.run(rung, size);
        } catch (RuntimeException problem) {
            seen = Finding.demanded(false, "threw " + problem);
        }
        return new StabilityRow(each.name(), each.demand(), rung.name(), seen, (System.nanoTime() - start) / NANOS);
    }

    /** True if the demand was not met. */
    public boolean failed() {
        return seen.verdict() == Finding.Verdict.FAILS;
    }
}
