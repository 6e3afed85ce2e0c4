package steward.game.searchrace.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import steward.scene.SceneFiles;

/** Map of a race, found from its recorded lines: the first lines are all checkpoints of three laps. */
final class RecordedMap {

    private static final String SCENE = "search-race";
    private static final String BY_SEED = "\"official\": \"by seed\"";
    private static final int LAPS = 3;
    private static final Pattern COUNT = Pattern.compile("[0-9]{1,4}");
    private static final Pattern PLACE = Pattern.compile("-?[0-9]{1,7} -?[0-9]{1,7}");
    private static final Pattern TURN = Pattern.compile("0( -?[0-9]+){4} [0-9]+");

    /** The official scene on the map, {@code null} if these are no lines of this game. */
    static String sceneOf(List<String> lines) {
        int all = lines.isEmpty() || !COUNT.matcher(lines.get(0)).matches() ? 0 : Integer.parseInt(lines.get(0));
        if (all < 2 * LAPS || all % LAPS != 0 || lines.size() < all + 2
                || !TURN.matcher(lines.get(all + 1)).matches()) {
            return null;
        }
        int checkpoints = all / LAPS;
        for (int k = 1; k <= all; k++) {
            String line = lines.get(k);
            if (!PLACE.matcher(line).matches() || k > checkpoints && !line.equals(lines.get(k - checkpoints))) {
                return null;
            }
        }
        return sceneOfLap(lines.subList(1, checkpoints + 1));
    }

    /** The official scene on the map of a lap: {@code x y} of each checkpoint, as they are to be passed. */
    static String sceneOfLap(List<String> lap) {
        List<String> points = new ArrayList<>();
        lap.forEach(place -> points.add("{ \"x\": " + place.replace(" ", ", \"y\": ") + " }"));
        points.add(0, points.remove(points.size() - 1));            // laps begin with the second and end at the first
        return SceneFiles.load(SCENE).text().replace(BY_SEED, "\"points\": [" + String.join(", ", points) + "]");
    }
}
