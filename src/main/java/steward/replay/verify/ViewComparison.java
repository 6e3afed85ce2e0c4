package steward.replay.verify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import steward.game.ViewWriter;
import steward.replay.JsonLine;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import steward.text.TextFormat;

/** The frames of a server beside those that it would have written of ours: line by line, word by word. */
final class ViewComparison {

    /** The field of a turn's outcome, and of the state at the start, that holds the frames. */
    static final String FRAMES = "frames";

    private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");

    private final ViewWriter writer;
    private boolean any;
    private long values;
    private int missing;

    ViewComparison(ViewWriter writer) {
        this.writer = writer;
    }

    ViewCounts counts() {
        if (!any) {
            return ViewCounts.NONE;
        }
        List<String> notCompared = new ArrayList<>(writer.notCompared());
        if (missing > 0) {
            notCompared.add(TextFormat.count(missing, "text") + " of frames that the recording lacks");
        }
        return new ViewCounts(values, notCompared);
    }

    /** @return the first difference, or {@code null} */
    Difference start(ReplayReader replay) {
        JsonLine state = new JsonLine(replay.source() + ":1: start.state",
            new JsonLine(replay.source() + ":1: start", replay.start()).object("state"));
        List<JsonLine> frames = state.has(FRAMES) ? state.objects(FRAMES) : List.of();
        if (frames.isEmpty()) {
            return null;
        }
        JsonLine frame = frames.get(0);
        ViewWriter.Frame start = writer.start();
        Difference difference = compare(0, frame, "view", start.view(), true);
        return difference != null ? difference : compare(0, frame, "summary", start.summary(), false);
    }

    /**
     * Compares the frames of the turn just played.
     *
     * @param last true if it is the last by our rules
     * @return the first difference, or {@code null}
     */
    Difference turn(RecordedTurn turn, boolean last) {
        JsonLine outcome = new JsonLine(turn.where() + ": outcome", turn.outcome());
        List<JsonLine> frames = outcome.has(FRAMES) ? outcome.objects(FRAMES) : List.of();
        Difference difference = null;
        for (int k = 0; k < frames.size() && difference == null; k++) {
            JsonLine frame = frames.get(k);
            if (k < frames.size() - 1) {
                difference = compare(turn.number(), frame, "view", writer.answer(k), false);
                continue;
            }
            ViewWriter.Frame found = writer.after(turn.messages(), lines(frame, "view"));
            difference = compare(turn.number(), frame, "view", found.view(), true);
            if (difference == null) {
                difference = compare(turn.number(), frame, "summary", found.summary(), false);
            }
            if (difference == null && last && writer.scores() != null) {
                difference = compare(turn.number(), frame, "scores", List.of(Arrays.toString(writer.scores())
                    .replaceAll("[\\[\\],]", "")), false);
            }
        }
        return difference;
    }

    /** The lines of one text of a frame; none if it is absent or blank. */
    private List<String> lines(JsonLine frame, String name) {
        String text = frame.has(name) ? frame.text(name).stripTrailing() : "";
        return text.isEmpty() ? List.of() : name.equals("view") ? writer.lines(text)
            : List.of(text.split("\r?\n", -1));
    }

    /** @param mayEnd true if the text may end where the writer says so */
    private Difference compare(int turn, JsonLine frame, String name, List<String> found, boolean mayEnd) {
        List<String> recorded = lines(frame, name);
        if (!frame.has(name)) {
            missing += name.equals("scores") || found.isEmpty() ? 0 : 1;
            return null;
        }
        any = true;
        for (int line = 0; line < Math.max(recorded.size(), found.size()); line++) {
            if (line >= recorded.size() && mayEnd && writer.mayEndAt(line)) {
                return null;
            }
            if (line >= found.size() - 1 && !found.isEmpty() && found.get(found.size() - 1).equals(ViewWriter.REST)) {
                return null;
            }
            boolean both = line < recorded.size() && line < found.size();
            String where = name + " line " + line;
            Difference difference = both ? compare(turn, where, words(recorded.get(line)), words(found.get(line)))
                : new Difference(turn, where, line < recorded.size() ? recorded.get(line) : "nothing",
                    line < found.size() ? found.get(line) : "nothing");
            if (difference != null) {
                return difference;
            }
        }
        return null;
    }

    private static List<String> words(String line) {
        return line.isBlank() ? List.of() : Arrays.asList(line.strip().split("\\s+"));
    }

    private Difference compare(int turn, String where, List<String> recorded, List<String> found) {
        List<String> all = new ArrayList<>(found);
        boolean rest = !all.isEmpty() && all.get(all.size() - 1).equals(ViewWriter.REST);
        if (rest) {
            all.remove(all.size() - 1);
        }
        for (int k = 0; k < (rest ? all.size() : Math.max(recorded.size(), all.size())); k++) {
            String ours = k < all.size() ? all.get(k) : "nothing";
            String theirs = k < recorded.size() ? recorded.get(k) : "nothing";
            if (k < recorded.size() && ours.equals(ViewWriter.ANY)) {
                continue;
            }
            if (k >= recorded.size() || k >= all.size() || !isSame(theirs, ours)) {
                return new Difference(turn, where + ", word " + k, theirs, ours);
            }
            values++;
        }
        return null;
    }

    /** Numbers are equal if they are the same double: different programs write it in different ways. */
    private static boolean isSame(String recorded, String found) {
        return recorded.equals(found) || NUMBER.matcher(recorded).matches() && NUMBER.matcher(found).matches()
            && Double.parseDouble(recorded) == Double.parseDouble(found);
    }
}
