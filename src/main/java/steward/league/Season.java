package steward.league;

import steward.files.JarFolder;
import steward.game.GameSetup;
import steward.scene.Scene;
import steward.scene.SceneKey;

/**
 * Conditions that all games of a season share, so that they can be compared: the scene, the time limits, the rules.
 *
 * @param sceneName the scene's name
 * @param sceneKey  of all in the scene that decides what happens
 * @param limits    the time limits and what they are limits of
 * @param rules     the key of its rung's law, its rung, the word of its angles, and the digest of the game's jar where
 *                  it has one
 * @param players   of a game
 * @param lowerScoreIsBetter where each plays alone: whether the lower of two scores on a map is the better one
 */
public record Season(String key, String sceneName, String sceneKey, String limits, String rules, int players,
                     boolean lowerScoreIsBetter) {

    /** The season of a scene under these settings. */
    public static Season of(GameSetup setup, LeagueSettings settings) {
        Scene scene = setup.scene();
        String sceneKey = SceneKey.of(scene);
        String limits = scene.time().firstAnswerMs() + " ms, " + scene.time().answerMs() + " ms, "
            + settings.limits();
        String rules = setup.plan().law().key() + " " + scene.accuracy().text() + " CORRECTLY_ROUNDED"
            + (JarFolder.digestOf(setup) == null ? "" : " " + JarFolder.digestOf(setup));
        return of(scene.name(), sceneKey, limits, rules, scene.players(), setup.create(0).lowerScoreIsBetter());
    }

    public static Season of(String sceneName, String sceneKey, String limits, String rules, int players,
                            boolean lowerScoreIsBetter) {
        return new Season(new TextHash().add(sceneKey).add(limits).add(rules).hex(), sceneName, sceneKey, limits,
            rules, players, lowerScoreIsBetter);
    }

    private String jar() {
        int at = rules.indexOf(" sha256:");
        return at < 0 ? "" : rules.substring(at);
    }

    /** What differs from another season, for a person. */
    public String difference(Season other) {
        if (!sceneKey.equals(other.sceneKey)) {
            return sceneName.equals(other.sceneName) ? "the scene " + sceneName + " has been changed"
                : "the scene is another one (" + other.sceneName + ", was " + sceneName + ")";
        }
        if (!limits.equals(other.limits)) {
            return "the time limits are " + other.limits + ", were " + limits;
        }
        if (!jar().equals(other.jar())) {
            return "the files of the game are others";
        }
        String rung = rules.substring(rules.indexOf(' ') + 1);
        return other.rules.endsWith(" " + rung) ? "the law of " + rung.replaceFirst(" .*", "") + " is another version"
            : "the version of the rules is another one";
    }
}
