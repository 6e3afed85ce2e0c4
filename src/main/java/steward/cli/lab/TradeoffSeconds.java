package steward.cli.lab;

import java.util.Map;

/** How long the scenes of {@code steward tradeoff} take, approximately. */
final class TradeoffSeconds {

    /**
     * With {@code --quick} and without, measured once on two processors that did other work too; without it the first
     * three, the others so that all take 288 s, as was measured.
     */
    private static final Map<String, int[]> SECONDS = Map.of("official-race", new int[] {7, 45},
        "brawl", new int[] {7, 45}, "dense-box", new int[] {6, 82}, "gas", new int[] {20, 25},
        "bullets", new int[] {10, 25}, "grazing", new int[] {7, 25}, "walled-race", new int[] {10, 35},
        "headings", new int[] {2, 6});
    /** Another scene takes about as long as the walled race. */
    private static final int[] OTHER = {10, 45};

    private TradeoffSeconds() {
    }

    static double of(String scene, boolean quick) {
        return SECONDS.getOrDefault(scene, OTHER)[quick ? 0 : 1];
    }
}
