package steward.game.searchrace;

import java.util.List;
import java.util.Map;
import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * Settings of a search race: the blocks {@code race} and {@code map} of a scene.
 *
 * @param laps             1..100
 * @param checkpointRadius in u
 * @param maximumTurns     the race is lost with the last of these turns, 1..{@link #LOST}
 * @param map              the checkpoints {@code [n][x, y]}, or {@code null} where the seed says which official map it
 *                         is: seed mod 50 in their order
 */
public record SearchRaceSettings(int laps, double checkpointRadius, int maximumTurns, double[][] map) {

    /** The score of a race that is not won, worse than every time. */
    public static final int LOST = 1000;
    /** The greatest thrust of a command, in u per turn^2. */
    public static final int MAXIMUM_THRUST = 200;
    /** The most degrees that a command turns by. */
    public static final int MAXIMUM_TURN = 18;

    private static final int MAXIMUM_CHECKPOINTS = 64;
    private static final int MAXIMUM_COORDINATE = 1_000_000;

    /** Reads the blocks {@code race} and {@code map}. */
    public static SearchRaceSettings read(Scene scene) {
        Block race = scene.root().block("race");
        int laps = race.integer("laps", 1, 100);
        double radius = race.positive("checkpointRadius");
        int maximumTurns = race.integer("maximumTurns", 1, LOST);
        race.done();
        Block block = scene.root().block("map");
        double[][] map = map(block);
        block.done();
        return new SearchRaceSettings(laps, radius, maximumTurns, map);
    }

    private static double[][] map(Block block) {
        if (block.has("points")) {
            if (block.has("official")) {
                throw block.error("official and points", "one of them");
            }
            return points(block);
        }
        if (block.isText("official")) {
            block.choice("official", Map.of("by seed", true));
            return null;
        }
        int number = block.integer("official", 1, SearchRaceMaps.numbers().get(SearchRaceMaps.COUNT - 1));
        int index = SearchRaceMaps.numbers().indexOf(number);
        if (index < 0) {
            throw block.error("official", Integer.toString(number),
                "the number of an official map: 1, 2, 7..50, 700, 701, 702 or 704");
        }
        return SearchRaceMaps.map(index);
    }

    private static double[][] points(Block block) {
        List<Block> points = block.blocks("points");
        if (points.size() < 2 || points.size() > MAXIMUM_CHECKPOINTS) {
            throw block.error("points", points.size() + " checkpoints", "2.." + MAXIMUM_CHECKPOINTS);
        }
        double[][] map = new double[points.size()][];
        for (int k = 0; k < map.length; k++) {
            Block point = points.get(k);
            map[k] = new double[] {point.integer("x", -MAXIMUM_COORDINATE, MAXIMUM_COORDINATE),
                point.integer("y", -MAXIMUM_COORDINATE, MAXIMUM_COORDINATE)};
            point.done();
        }
        return map;
    }

    /** The checkpoints of the game with this seed, {@code [n][x, y]}. */
    double[][] map(long seed) {
        return map != null ? map : SearchRaceMaps.map((int) Math.floorMod(seed, (long) SearchRaceMaps.COUNT));
    }
}
