package steward.match;

import java.util.List;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.scene.SceneFiles;

/** The scenes that tests play: the shipped ones, and the duel changed a little. */
public final class TestScenes {

    /** The games that tests know. */
    public static final GameTypes TYPES = GameTypes.installed();

    /** Every shipped scene of a two-player pod race that is worth a whole match: official, walled, small. */
    public static final List<String> SHIPPED = List.of("mad-pod-racing", "walled-race", "duel");

    private TestScenes() {
    }

    /** A scene of {@code config/scenes}. */
    public static GameSetup open(String name) {
        return TYPES.open(text(name), name);
    }

    /** The duel for another number of players. */
    public static GameSetup duel(int players) {
        return changed("duel", "\"players\": 2", "\"players\": " + players);
    }

    /** A shipped scene in which one piece of text, which must be there, is another. */
    public static GameSetup changed(String name, String from, String to) {
        String text = text(name);
        if (!text.contains(from)) {
            throw new IllegalArgumentException(name + " has no " + from);
        }
        return TYPES.open(text.replace(from, to), name + ", changed");
    }

    /** A shipped pod race with the rules of the contest. */
    public static GameSetup contest(String name) {
        return changed(name, "\"rules\": \"live\"", "\"rules\": \"contest\"");
    }

    /** The file of a shipped scene. */
    public static String text(String name) {
        return SceneFiles.load("config/scenes/" + name + ".json").text();
    }
}
