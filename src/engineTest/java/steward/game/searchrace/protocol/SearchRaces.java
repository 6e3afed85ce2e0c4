package steward.game.searchrace.protocol;

import java.util.ArrayList;
import java.util.List;
import steward.game.searchrace.SearchRace;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;

/** Races on maps of choice, by the official scene. */
public final class SearchRaces {

    private SearchRaces() {
    }

    /** Opens the official scene with some texts, each of which must be there, replaced. */
    public static SearchRaceType.SearchRaceSetup changed(String... fromTo) {
        String text = SceneFiles.load("search-race").text();
        for (int k = 0; k < fromTo.length; k += 2) {
            if (!text.contains(fromTo[k])) {
                throw new IllegalArgumentException("no " + fromTo[k]);
            }
            text = text.replace(fromTo[k], fromTo[k + 1]);
        }
        return new SearchRaceType().open(SceneReader.read(text, "search-race.json"));
    }

    /** The official scene on a map in the form {@code x y;x y}. */
    static SearchRaceType.SearchRaceSetup map(String map) {
        List<String> points = new ArrayList<>();
        for (String point : map.split(";")) {
            String[] words = point.split(" ");
            points.add("{ \"x\": " + words[0] + ", \"y\": " + words[1] + " }");
        }
        return changed("\"official\": \"by seed\"", "\"points\": [" + String.join(", ", points) + "]");
    }

    /** A race on a map in the form {@code x y;x y}. */
    public static SearchRace onMap(String map) {
        return map(map).create(1);
    }
}
