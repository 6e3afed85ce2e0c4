package steward.game;

import steward.json.DrawingJson;
import tools.jackson.core.JsonGenerator;

/** Shapes to draw of one {@link Game}, constant over the game; {@link DrawingJson} writes them. */
@FunctionalInterface
public interface Drawing {

    /**
     * Fields that say what to draw: {@code field} (x, y, width, height), {@code walls}, {@code zones} (x, y, radius,
     * label) and {@code bodies} (id, radius, owner, kind, label).
     */
    void write(JsonGenerator out);
}
