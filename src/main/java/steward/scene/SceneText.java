package steward.scene;

/**
 * A scene file, not yet read.
 *
 * @param text   all of it
 * @param source how errors name it
 */
public record SceneText(String text, String source) {
}
