package steward.codingame.recording;

import java.util.List;
import java.util.StringJoiner;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.JsonNode;

/**
 * The texts of a frame that say how the game stands, as the server wrote them: an imported replay keeps them, and its
 * verification compares them word by word.
 *
 * @param view    or {@code null}
 * @param summary or {@code null}
 */
record ShownFrame(String view, String summary) {

    /** The texts of a frame of the site's JSON; anything but a text counts as none. */
    static ShownFrame of(JsonNode frame) {
        return new ShownFrame(frame.path("view").asString(null), frame.path("summary").asString(null));
    }

    /**
     * Writes the field {@code frames}; nothing if no frame says anything.
     *
     * @param scores the final scores, to be told with the last frame of a game; empty for others
     */
    static void write(JsonGenerator out, List<ShownFrame> frames, double... scores) {
        if (scores.length == 0 && frames.stream().allMatch(frame -> frame.view == null && frame.summary == null)) {
            return;
        }
        JsonObject.writeAll(out, "frames", frames.size(), k -> {
            ShownFrame frame = frames.get(k);
            if (frame.view != null) {
                out.writeStringProperty("view", frame.view);
            }
            if (frame.summary != null) {
                out.writeStringProperty("summary", frame.summary);
            }
            if (scores.length > 0 && k == frames.size() - 1) {
                StringJoiner words = new StringJoiner(" ");
                for (double score : scores) {
                    words.add(Double.toString(score));
                }
                out.writeStringProperty("scores", words.toString());
            }
        });
    }
}
