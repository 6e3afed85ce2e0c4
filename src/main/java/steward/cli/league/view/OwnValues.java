package steward.cli.league.view;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.report.Fields;
import steward.report.MeanValue;
import steward.report.Table;
import steward.text.TextFormat;

/**
 * Means and standard deviations, by bot, of the values of its games: score, turns, and values that the game itself
 * counts.
 */
public final class OwnValues {

    private static final int WIDTH = 20;

    private final Map<Integer, Map<String, MeanValue>> sums = new TreeMap<>();

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
        sums.computeIfAbsent(version, any -> new TreeMap<>()).computeIfAbsent(name, any -> new MeanValue()).add(value);
    }

    private List<String> names() {
        return sums.values().stream().flatMap(each -> each.keySet().stream()).distinct().sorted().toList();
    }

    private MeanValue of(int version, String name) {
        return sums.getOrDefault(version, Map.of()).getOrDefault(name, new MeanValue());
    }

    /** A line for each bot in the order of the table, with a mean ± a standard deviation for each value. */
    List<String> lines(LeagueTable table) {
        Table<LeagueTable.Row> columns = new Table<LeagueTable.Row>().right("  #", 3, row -> "" + row.rank())
            .left("bot" + " ".repeat(WIDTH - 3), 1, row -> TextFormat.plain(TextFormat.shorten(row.entry().name(),
                WIDTH)));
        names().forEach(name -> columns.right(name, WIDTH, row -> of(row.entry().version(), name).text()));
        List<String> lines = columns.lines(table.rows());
        lines.add("Mean ± standard deviation of the games that have the value.");
        return lines;
    }

    /** Adds columns of mean and standard deviation to a table in CSV. @param version of a row */
    public <R> Table<R> addTo(Table<R> table, Function<R, Integer> version) {
        names().forEach(name -> table.value(name + "Mean", row -> of(version.apply(row), name).mean())
            .value(name + "Deviation", row -> of(version.apply(row), name).deviation()));
        return table;
    }

    /** By bot and value, games, mean and deviation. */
    Fields fields(LeagueTable table) {
        Fields bots = Fields.of();
        for (LeagueTable.Row row : table.rows()) {
            Fields values = Fields.of();
            sums.getOrDefault(row.entry().version(), Map.of()).forEach((name, sum) -> values.with(name,
                Fields.of("games", sum.count(), "mean", sum.mean(), "deviation", sum.deviation())));
            bots.with(row.entry().name(), values);
        }
        return bots;
    }
}
