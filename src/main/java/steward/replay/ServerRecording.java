package steward.replay;

import java.util.ArrayList;
import java.util.List;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;

/**
 * The site's own recording of a match, kept in a replay beside ours: the texts of its frames, word for word, and its
 * result. They are the fields {@code server} of header, turns and result.
 */
public final class ServerRecording {

    private final List<List<Frame>> frames = new ArrayList<>();
    private End end;

    /**
     * The texts of a frame; {@code null} where there is none.
     *
     * @param information for people about the answer of the frame
     * @param tooltips    a line for each, which begins with its player
     * @param aside       true for a frame of the server's referee that ends no turn, which is not compared
     */
    public record Frame(String view, String summary, String information, String tooltips, boolean aside) {

        /** Frame that the recording lacks. */
        public static final Frame LACKING = new Frame(null, null, null, null, false);

        private static final String VIEW = "view";
        private static final String SUMMARY = "summary";
        private static final String INFORMATION = "information";
        private static final String TOOLTIPS = "tooltips";
        private static final String ASIDE = "aside";

        static void writeAll(JsonGenerator out, String name, List<Frame> frames) {
            JsonObject.writeAll(out, name, frames, frame -> {
                writeText(out, VIEW, frame.view);
                writeText(out, SUMMARY, frame.summary);
                writeText(out, INFORMATION, frame.information);
                writeText(out, TOOLTIPS, frame.tooltips);
                if (frame.aside) {
                    out.writeBooleanProperty(ASIDE, true);
                }
            });
        }

        static List<Frame> readAll(JsonLine line, String name) {
            return !line.has(name) ? List.of() : line.objects(name).stream().map(frame ->
                new Frame(readText(frame, VIEW), readText(frame, SUMMARY), readText(frame, INFORMATION),
                    readText(frame, TOOLTIPS), frame.flag(ASIDE))).toList();
        }
    }

    /**
     * End of a match as the server tells it.
     *
     * @param turns  that it has played
     * @param frames behind the end of the game by our rules
     * @param ranks  per player, with blanks between, 0 for the best; {@code null} if not recorded
     * @param scores likewise
     * @param input  what the server's referee was given; {@code null} if not recorded or not compared
     * @param data   values for those who evaluate games, likewise
     */
    public record End(int turns, List<Frame> frames, String ranks, String scores, String input, String data) { }

    /** Adds the frames of the next turn; first those of the start. */
    public void add(List<Frame> next) {
        frames.add(List.copyOf(next));
    }

    /** The frames of a turn; of turn 0 those of the start. */
    public List<Frame> frames(int turn) {
        return frames.get(turn);
    }

    /** Sets the result. */
    public void end(End result) {
        end = result;
    }

    /** The result, or {@code null}. */
    public End end() {
        return end;
    }

    /** Reads the frames of the next line, or the result. */
    public void read(JsonLine line) {
        if (!line.text("type").equals(LineFields.RESULT_TYPE)) {
            add(Frame.readAll(line, LineFields.SERVER));
        } else if (line.has(LineFields.SERVER)) {
            JsonLine of = new JsonLine(line.where() + ": " + LineFields.SERVER, line.object(LineFields.SERVER));
            end = new End(of.integer("turns"), Frame.readAll(of, "frames"), readText(of, "ranks"),
                readText(of, "scores"), readText(of, "input"), readText(of, "data"));
        }
    }

    /** Writes the frames of a turn. */
    void write(JsonGenerator out, int turn) {
        Frame.writeAll(out, LineFields.SERVER, frames(turn));
    }

    /** Writes the result. */
    void writeEnd(JsonGenerator out) {
        if (end != null) {
            out.writeObjectPropertyStart(LineFields.SERVER);
            out.writeNumberProperty("turns", end.turns);
            if (!end.frames.isEmpty()) {
                Frame.writeAll(out, "frames", end.frames);
            }
            writeText(out, "ranks", end.ranks);
            writeText(out, "scores", end.scores);
            writeText(out, "input", end.input);
            writeText(out, "data", end.data);
            out.writeEndObject();
        }
    }

    private static void writeText(JsonGenerator out, String name, String text) {
        if (text != null) {
            out.writeStringProperty(name, text);
        }
    }

    private static String readText(JsonLine line, String name) {
        return line.has(name) ? line.text(name) : null;
    }
}
