package steward.lab.stability;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import steward.lab.trial.Finding;
import steward.lab.trial.Progress;
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

    /**
     * Runs cases on rungs, one after the other. An exception that a case did not expect is a failure.
     *
     * @param before   called before each case and rung
     * @param progress receives the progress of the current one
     * @param after    receives each row as soon as it is known
     */
    public static void tryAll(List<StabilityCase> cases, List<Rung> rungs, RunLength size,
                              BiConsumer<StabilityCase, Rung> before, Progress progress,
                              Consumer<StabilityRow> after) {
        for (StabilityCase each : cases) {
            for (Rung rung : rungs) {
                before.accept(each, rung);
                long start = System.nanoTime();
                Finding seen;
                try {
                    seen = each.run(rung, size, progress);
                } catch (RuntimeException problem) {
                    seen = Finding.demanded(false, "threw " + problem);
                }
                after.accept(new StabilityRow(each.name(), each.demand(), rung.name(), seen,
                    (System.nanoTime() - start) / NANOS));
            }
        }
    }

    /** True if the demand was not met. */
    public boolean failed() {
        return seen.verdict() == Finding.Verdict.FAILS;
    }
}
