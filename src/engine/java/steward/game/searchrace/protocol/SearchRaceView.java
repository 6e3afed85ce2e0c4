package steward.game.searchrace.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.ServerView;
import steward.text.ViewLines;
import tools.jackson.databind.JsonNode;

/** Reader of a search race's map from a server's recording: the views have no title, but checkpoints with tooltips. */
final class SearchRaceView implements ServerView {

    private static final Pattern CHECKPOINT = Pattern.compile("Checkpoint\nx = (-?[0-9]{1,7})\ny = (-?[0-9]{1,7})");
    private static final Pattern TEST = Pattern.compile("(?m)^(-?[0-9]+ -?[0-9]+;)+-?[0-9]+ -?[0-9]+$");

    @Override
    public String title() {
        return "Search Race";
    }

    @Override
    public boolean isOf(ViewLines first) {
        return !places(first).isEmpty();
    }

    /** The places of all checkpoints, {@code x y}, in the order of their entities; empty if it is no search race. */
    private static List<String> places(ViewLines first) {
        JsonNode frame = GraphicsLines.json(first.line(1));
        Map<Integer, String> places = new TreeMap<>();
        if (frame != null) {
            for (JsonNode tips : frame.path("tooltips")) {
                for (Map.Entry<String, JsonNode> tip : tips.properties()) {
                    Matcher matcher = CHECKPOINT.matcher(tip.getValue().asString(""));
                    if (matcher.matches() && tip.getKey().matches("[0-9]{1,7}")) {
                        places.put(Integer.parseInt(tip.getKey()), matcher.group(1) + " " + matcher.group(2));
                    }
                }
            }
        }
        return new ArrayList<>(places.values());
    }

    @Override
    public Start open(ViewLines first, String input) {
        List<String> lap = places(first);
        if (lap.size() < 2) {
            throw first.wrong(1, "tooltips of two checkpoints at least");
        }
        Matcher test = TEST.matcher(input.replace("\r", ""));
        String map = String.join(";", lap);
        if (test.find() && !test.group().equals(map)) {
            throw new IllegalArgumentException(first.source() + ": refereeInput: found " + ViewLines.quote(test.group())
                + ", expected the checkpoints of frame 0, " + ViewLines.quote(map));
        }
        lap.add(lap.remove(0));
        return new Start(RecordedMap.sceneOfLap(lap), 0);
    }
}
