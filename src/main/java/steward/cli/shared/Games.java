package steward.cli.shared;

import java.util.List;
import steward.cli.streams.StandardFiles;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.GameTypes;
import steward.guest.GuestType;
import steward.scene.Accuracy;
import steward.scene.Scene;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import steward.scene.SceneText;
import steward.scene.json.SceneException;

/** Scenes of all games that the program knows, for commands: opened, refused, or warned of if something is odd. */
public final class Games {

    /** The game that commands play unless another is called for. */
    public static final String FIRST = "pod-race";

    private Games() { }

    /** All games: those of the program, and those of the user's jars. */
    public static GameTypes types() {
        return types(false);
    }

    /** All games. @param trusted whether replays may be played again by the referees that they name */
    public static GameTypes types(boolean trusted) {
        return GameTypes.installed().withGuests(new GuestType(trusted));
    }

    /** The weakest bundled bot of a game, or {@code null} if it has none. */
    public static String weakestBot(String game) {
        return types().of(game).map(GameType::weakestBot).orElse(null);
    }

    public static List<String> ids() {
        return types().types().stream().map(GameType::id).toList();
    }

    /** Opens a scene by its path or shipped name. A scene whose games cannot begin is refused. */
    public static GameSetup open(String scene) {
        return open(scene, null);
    }

    /** @param accuracy the rung to use, or {@code null} for the scene's own */
    public static GameSetup open(String scene, Accuracy accuracy) {
        return open(SceneFiles.load(scene), accuracy);
    }

    /** Opens as {@link #open(String, Accuracy)} does; {@code -} is the scene on the standard input. */
    public static GameSetup open(String scene, Accuracy accuracy, Streams streams) {
        return open(StandardFiles.is(scene) ? StandardFiles.readScene(streams) : SceneFiles.load(scene), accuracy);
    }

    private static GameSetup open(SceneText scene, Accuracy accuracy) {
        GameSetup setup = types().open(SceneReader.read(scene, accuracy));
        setup.check();
        return setup;
    }

    /** Refuses a scene with a referee of its own. @param use of the scene, as a command or option is called */
    public static GameSetup computed(GameSetup setup, String use) {
        requireComputed(setup.scene().gameId(), setup.scene().name(), use);
        return setup;
    }

    /** Refuses a match by a referee of its own. @param use of it, as a command or option is called */
    public static void requireComputed(String game, String scene, String use) {
        if (game.equals(GuestType.ID)) {
            throw new InputException(use + ": found the scene \"" + scene + "\", which has a referee of its own, "
                + "expected a game that Steward computes");
        }
    }

    /** The scene with another bound on its turns. */
    public static GameSetup withTurns(GameSetup setup, int turns) {
        String text = types().of(setup.scene().gameId()).orElseThrow().withTurns(setup.scene(), turns);
        if (text == null) {
            throw new InputException("--turns: found a scene of " + setup.scene().gameId()
                + ", which has no bound on its turns, expected none with it");
        }
        try {
            return types().open(text, setup.scene().root().source());
        } catch (SceneException refused) {             // the scene itself was read before: it is the number
            throw new InputException(refused.getMessage().replaceFirst(".*: found ", "--turns: found "));
        }
    }

    /** Describes the official scene of a game in a few words: the game itself says it. */
    public static String about(String scene) {
        Scene of = open(scene).scene();
        return types().of(of.gameId()).orElseThrow().about(of);
    }

    /** Prints what is odd about a scene; once per call of the program. */
    public static GameSetup warn(GameSetup setup, Streams streams) {
        setup.check().forEach(streams::warn);
        return setup;
    }
}
