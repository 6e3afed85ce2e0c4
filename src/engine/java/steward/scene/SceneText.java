package steward.scene;

import java.nio.file.Path;
import java.util.Optional;

/**
 * Text of a scene file that has not been parsed yet.
 *
 * @param source  how errors name it
 * @param figures where the figures of its accuracy would be, existing or not; empty for a text that is not a file
 */
public record SceneText(String text, String source, Optional<Path> figures) {

    /** A text that is not a file. */
    public SceneText(String text, String source) {
        this(text, source, Optional.empty());
    }
}
