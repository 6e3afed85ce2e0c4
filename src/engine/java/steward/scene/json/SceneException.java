package steward.scene.json;

/**
 * Error in a scene file. The message is complete and meant for the author of the file: {@code FILE:LINE:COLUMN:
 * field.path: found ..., expected ...}; without a position if the file itself is missing.
 */
public final class SceneException extends RuntimeException {

    public SceneException(String message) {
        super(message);
    }

    /** @param path of the field from the root, or empty for the whole file */
    static SceneException at(String source, SourcePosition place, String path, String problem) {
        return new SceneException(source + ":" + place.line() + ":" + place.column() + ": "
            + (path.isEmpty() ? "" : path + ": ") + problem);
    }
}
