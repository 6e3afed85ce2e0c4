package steward.lab.cli;

import java.util.Map;

/** Approximate seconds of the scenes of {@code steward tradeoff}. */
final class TradeoffSeconds {

    /** With {@code --quick}, without, and in each JVM of a rung without, on two processors. */
    private static final Map<String, int[]> SECONDS = Map.of("dense-box", new int[] {12, 20, 16},
        "gas", new int[] {20, 60, 20}, "bullets", new int[] {14, 15, 14}, "bowl", new int[] {60, 100, 80},
        "avalanche", new int[] {30, 30, 20}, "headings", new int[] {2, 4, 0});
    /** Another scene takes about as long as a race. */
    private static final int[] OTHER = {12, 8, 12};

    static double of(String scene, boolean quick, int jvms) {
        int[] seconds = SECONDS.getOrDefault(scene, OTHER);
        return quick ? seconds[0] : seconds[1] + jvms * seconds[2];
    }
}
