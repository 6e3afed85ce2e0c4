package steward.machines.check;

import steward.files.JarFolder;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.scene.json.SceneException;

/**
 * Digest of the installed jar that has a league's game, compared between league and worker. No message brings a jar, so
 * the worker's owner has to install it.
 */
public final class GameJar {

    private static final String NONE = "none";

    private GameJar() { }

    /** Returns the digest of the installed jar with the scene's game, or {@code none}. */
    public static String installed(GameTypes types, String scene) {
        try {
            GameSetup setup = types.open(scene, "the league's scene");
            String digest = JarFolder.digestOf(setup);
            return digest == null ? NONE : digest;
        } catch (SceneException notInstalled) {
            return NONE;
        }
    }

    /** Returns the line that both sides print if the worker has another jar, or none. */
    public static String missing(String found, String expected) {
        return "found " + (NONE.equals(found) ? "no jar" : "the jar " + found) + " of the league's game, expected "
            + expected + " in the worker's folder of games (--games-path), or of bundles (--bundles) for a guest";
    }
}
