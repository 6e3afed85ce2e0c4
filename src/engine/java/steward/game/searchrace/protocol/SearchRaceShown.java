package steward.game.searchrace.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.ServerView;
import steward.json.JsonNumbers;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.JsonNode;

/**
 * A search race as the views of the server show it. The form is that of the published referee, Illedan/CGSearchRace,
 * with the site's toolkit, as its demonstration shows it; no game of the server itself was at hand. Entities are
 * numbered as the referee makes them: {@link SearchRaceViews} names them. The tooltips have whole places; a race that
 * is finished is declared so in a frame more, in which nobody is asked.
 */
final class SearchRaceShown implements ServerView.Shown {

    private static final Pattern CHECKPOINT = Pattern.compile("Checkpoint\nx = (-?[0-9]{1,7})\ny = (-?[0-9]{1,7})");
    private static final Pattern CAR = Pattern.compile("Car\nx = (-?[0-9]{1,9})\ny = (-?[0-9]{1,9})");
    private static final Pattern TARGET = Pattern.compile("'[0-9]+ \\(([0-9]{1,6})\\)'");
    private static final Pattern TIME = Pattern.compile("[0-9]{1,4}\\.[0-9]{1,2}");
    private static final Pattern TEST = Pattern.compile("(?m)^(-?[0-9]+ -?[0-9]+;)+-?[0-9]+ -?[0-9]+$");
    private static final int MOST_TURNS = 10_000;

    private final List<String> checkpoints;
    private final List<Turn> turns = new ArrayList<>();
    private final Turn start;
    private double time = Double.NaN;

    /** The car's state after a turn, as far as it is shown. */
    private record Turn(String x, String y, int passed, int timer) { }

    SearchRaceShown(ViewLines first, String input) {
        checkpoints = List.copyOf(places(GraphicsLines.json(first.line(1))).values());
        if (checkpoints.size() < 2) {
            throw first.wrong(1, "tooltips of two checkpoints at least");
        }
        Matcher test = TEST.matcher(input.replace("\r", ""));
        String map = String.join(";", checkpoints);
        if (test.find() && !test.group().equals(map)) {
            throw new IllegalArgumentException(first.source() + ": refereeInput: found " + ViewLines.quote(test.group())
                + ", expected the checkpoints of frame 0, " + ViewLines.quote(map));
        }
        String[] place = checkpoints.get(0).split(" ");
        start = new Turn(place[0], place[1], 0, 0);
    }

    /** The places of all checkpoints, {@code x y}, by the numbers of their entities; empty if it is no search race. */
    static Map<Integer, String> places(JsonNode frame) {
        Map<Integer, String> places = new TreeMap<>();
        for (JsonNode tips : frame.path("tooltips")) {
            for (Map.Entry<String, JsonNode> tip : tips.properties()) {
                Matcher matcher = CHECKPOINT.matcher(tip.getValue().asString(""));
                if (matcher.matches() && tip.getKey().matches("[0-9]{1,7}")) {
                    places.put(Integer.parseInt(tip.getKey()), matcher.group(1) + " " + matcher.group(2));
                }
            }
        }
        return places;
    }

    @Override
    public String scene() {
        List<String> lap = new ArrayList<>(checkpoints.subList(1, checkpoints.size()));
        lap.add(checkpoints.get(0));
        return RecordedMap.sceneOfLap(lap);
    }

    @Override
    public long seed() {
        return 0;
    }

    @Override
    public void add(ViewLines view) {
        Turn before = turns.isEmpty() ? start : turns.get(turns.size() - 1);
        JsonNode frame = view.count() < 2 ? null : GraphicsLines.json(view.line(1));
        if (frame == null) {
            if (view.count() > 1) {
                throw view.wrong(1, "a JSON object");
            }
            turns.add(before);
            return;
        }
        String x = before.x;
        String y = before.y;
        Matcher car = CAR.matcher(frame.path("tooltips").path(0).path(Integer.toString(SearchRaceViews.CAR))
            .asString(""));
        if (car.matches()) {
            x = car.group(1);
            y = car.group(2);
        }
        int passed = before.passed;
        int timer = before.timer;
        SearchRaceViews.Entities entities = new SearchRaceViews.Entities(checkpoints.size());
        for (List<String> update : GraphicsLines.updates(frame)) {
            int text = update.indexOf("T");
            String value = text < 0 || text + 1 == update.size() ? "" : update.get(text + 1);
            if (update.get(0).equals(Integer.toString(entities.target()))) {
                Matcher target = TARGET.matcher(value);
                passed = target.matches() ? Integer.parseInt(target.group(1)) : passed;
            } else if (update.get(0).equals(Integer.toString(entities.timer())) && !value.isEmpty()) {
                timer = view.whole(value, MOST_TURNS, 1);
            }
        }
        readEnd(view, frame.path("endScreen"));
        turns.add(new Turn(x, y, passed, timer));
    }

    private void readEnd(ViewLines view, JsonNode end) {
        String text = end.path(2).path(0).asString("");
        if (!end.isMissingNode()) {
            if (!TIME.matcher(text).matches() || (int) Double.parseDouble(text) != end.path(0).path(0).asInt(-1)) {
                throw view.wrongWord(end.toString(), 1, "endScreen with a time twice, in whole turns and as a text");
            }
            time = Double.parseDouble(text);
        }
    }

    @Override
    public double score(int player, double... scores) {
        return time;
    }

    @Override
    public void writeStart(JsonGenerator out) {
        write(out, start);
    }

    @Override
    public void writeOutcome(JsonGenerator out, int turn) {
        out.writeObjectPropertyStart("state");
        write(out, turns.get(turn - 1));
        out.writeEndObject();
    }

    private static void write(JsonGenerator out, Turn turn) {
        out.writeArrayPropertyStart("bodies");
        out.writeStartObject();
        out.writeNumberProperty("id", 0);
        JsonNumbers.write(out, "x", Double.parseDouble(turn.x));
        JsonNumbers.write(out, "y", Double.parseDouble(turn.y));
        out.writeNumberProperty("passed", turn.passed);
        out.writeEndObject();
        out.writeEndArray();
        out.writeNumberProperty("timer", turn.timer);
    }
}
