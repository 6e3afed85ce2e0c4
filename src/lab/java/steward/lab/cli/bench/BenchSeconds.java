package steward.lab.cli.bench;

import java.util.Map;
import steward.lab.bench.Effort;

/** Approximate seconds of the parts of {@code steward bench}: for the announcement beforehand, and the time left. */
final class BenchSeconds {

    /**
     * Measured once on two processors that did other work too. Of {@code --quick}, all parts from pods to processes
     * together; league, crowds, a league of a million games and the crowds of {@code --long} are estimates.
     */
    private static final Map<String, int[]> SECONDS = Map.ofEntries(
        entry("matches", 6, 40, 80),
        entry("verify", 17, 26, 32),
        entry("processes", 30, 90, 110),
        entry("start", 4, 22, 42),
        entry("tools", 40, 250, 410),
        entry("referees", 60, 110, 160),
        entry("crowds", 8, 50, 300));

    private static Map.Entry<String, int[]> entry(String part, int quick, int normal, int full) {
        return Map.entry(part, new int[] {quick, normal, full});
    }

    static double of(String part, Effort effort) {
        return SECONDS.get(part)[effort.ordinal()];
    }
}
