package steward.cli.lab;

import java.util.Map;

/** How long the scenes of {@code steward tradeoff} take, approximately. */
final class TradeoffSeconds {

    /**
     * With {@code --quick} and without: each measured once on two busy processors but for the last two without it, and
     * those without it scaled to the 288 s that all took together.
     */
    private static final Map<String, int[]> SECONDS = Map.of("official-race", new int[] {7, 32},
        "brawl", new int[] {7, 32}, "dense-box", new int[] {6, 59}, "gas", new int[] {20, 50},
        "bullets", new int[] {10, 39}, "grazing", new int[] {7, 42}, "walled-race", new int[] {10, 30},
        "headings", new int[] {2, 4});
    /** Another scene takes about as long as the walled race. */
    private static final int[] OTHER = {10, 30};

    private TradeoffSeconds() {
    }

    static double of(String scene, boolean quick) {
        return SECONDS.getOrDefault(scene, OTHER)[quick ? 0 : 1];
    }
}
