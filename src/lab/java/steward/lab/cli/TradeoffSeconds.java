package steward.lab.cli;

import java.util.Map;

/** Approximate seconds of the scenes of {@code steward tradeoff}. */
final class TradeoffSeconds {

    /** With {@code --quick} and without, on two processors. */
    private static final Map<String, int[]> SECONDS = Map.of("official-race", new int[] {9, 50},
        "brawl", new int[] {9, 50}, "dense-box", new int[] {12, 90}, "gas", new int[] {20, 80},
        "bullets", new int[] {14, 70}, "grazing", new int[] {9, 50}, "walled-race", new int[] {12, 60},
        "headings", new int[] {2, 4});
    /** Another scene takes about as long as the walled race. */
    private static final int[] OTHER = {12, 60};

    private TradeoffSeconds() {
    }

    static double of(String scene, boolean quick) {
        return SECONDS.getOrDefault(scene, OTHER)[quick ? 0 : 1];
    }
}
