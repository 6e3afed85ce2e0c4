package steward.lab.cli.bench;

import java.util.Map;
import steward.lab.bench.Effort;

/** Approximate seconds of the parts of {@code steward bench}: for the announcement beforehand, and the time left. */
final class BenchSeconds {

    /**
     * Measured once on two processors that did other work too; games, a league of a million games and the
     * crowds of {@code --long} are estimates.
     */
    private static final Map<String, int[]> SECONDS = Map.of("pods", new int[] {4, 48, 104},
        "games", new int[] {4, 10, 25}, "matches", new int[] {3, 23, 62}, "growth", new int[] {3, 36, 73},
        "frames", new int[] {3, 19, 43}, "verify", new int[] {4, 26, 32}, "processes", new int[] {7, 20, 34},
        "league", new int[] {26, 110, 110}, "start", new int[] {4, 22, 42}, "crowds", new int[] {2, 46, 300});

    private BenchSeconds() {
    }

    static double of(String part, Effort effort) {
        return SECONDS.get(part)[effort.ordinal()];
    }
}
