package steward.cli.league.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import steward.json.JsonNumbers;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

/**
 * Means and standard deviations, by bot, of the values of its games: score, turns, and values that the game itself
 * counts.
 */
public final class OwnValues {

    private static final int WIDTH = 20;

    private final Map<Integer, Map<String, Sum>> sums = new TreeMap<>();

    /** Numbers of one kind; the mean and the sum of squares around it are carried on (Welford 1962). */
    private static final class Sum {
        private long count;
        private double mean;
        private double squares;

        private void add(double value) {
            count++;
            double before = value - mean;
            mean += before / count;
            squares += before * (value - mean);
        }

        private double deviation() {
            return count < 2 ? Double.NaN : Math.sqrt(squares / (count - 1));
        }
    }

    /** Adds a game, if it counts. */
    public void add(StoredGame game) {
        if (!game.isRated()) {
            return;
        }
        for (StoredGame.StoredSeat seat : game.seats()) {
            add(seat.version(), "score", seat.score());
            add(seat.version(), "turns", game.turns());
            seat.values().forEach((name, value) -> add(seat.version(), name, value));
        }
    }

    private void add(int version, String name, double value) {
        sums.computeIfAbsent(version, any -> new TreeMap<>()).computeIfAbsent(name, any -> new Sum()).add(value);
    }

    private List<String> names() {
        return sums.values().stream().flatMap(each -> each.keySet().stream()).distinct().sorted().toList();
    }

    /** A line for each bot in the order of the table, with a mean ± a standard deviation for each value. */
    List<String> lines(LeagueTable table) {
        List<String> names = names();
        List<String> lines = new ArrayList<>();
        StringBuilder head = new StringBuilder("  # " + TextFormat.left("bot", WIDTH));
        names.forEach(name -> head.append(TextFormat.right(name, WIDTH)));
        lines.add(head.toString());
        for (LeagueTable.Row row : table.rows()) {
            StringBuilder line = new StringBuilder(TextFormat.right(Integer.toString(row.rank()), 3) + " "
                + TextFormat.left(TextFormat.plain(TextFormat.shorten(row.entry().name(), WIDTH)), WIDTH));
            for (String name : names) {
                Sum sum = sums.getOrDefault(row.entry().version(), Map.of()).get(name);
                line.append(TextFormat.right(sum == null ? "-" : TextFormat.fixed(sum.mean, 2) + " ± "
                    + TextFormat.fixed(sum.deviation(), 2), WIDTH));
            }
            lines.add(line.toString());
        }
        lines.add("Mean ± standard deviation of the games that have the value.");
        return lines;
    }

    /** Heads of the columns that {@link #cells} fills. */
    public String[] heads() {
        return names().stream().flatMap(name -> Stream.of(name + "Mean", name + "Deviation")).toArray(String[]::new);
    }

    /** Mean and standard deviation of each value of a version; empty where there is none. */
    public String[] cells(int version) {
        Map<String, Sum> own = sums.getOrDefault(version, Map.of());
        return names().stream().map(own::get).flatMap(sum -> sum == null ? Stream.of("", "")
            : Stream.of(TableCommand.number(sum.mean), TableCommand.number(sum.deviation()))).toArray(String[]::new);
    }

    /** The field {@code values}: by bot and value, games, mean and deviation. */
    void json(JsonGenerator out, LeagueTable table) {
        out.writeObjectPropertyStart("values");
        for (LeagueTable.Row row : table.rows()) {
            out.writeObjectPropertyStart(row.entry().name());
            sums.getOrDefault(row.entry().version(), Map.of()).forEach((name, sum) -> {
                out.writeObjectPropertyStart(name);
                out.writeNumberProperty("games", sum.count);
                JsonNumbers.write(out, "mean", sum.mean);
                JsonNumbers.writeOrNull(out, "deviation", sum.deviation());
                out.writeEndObject();
            });
            out.writeEndObject();
        }
        out.writeEndObject();
    }
}
