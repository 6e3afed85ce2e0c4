package steward.cli.league.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.IntStream;
import steward.cli.streams.Colour;
import steward.league.Season;
import steward.league.page.ApartWords;
import steward.league.page.WorkerRow;
import steward.league.rating.Difference;
import steward.league.rating.LeagueTable;
import steward.league.rating.LeagueTable.Row;
import steward.report.Table;
import steward.text.TextFormat;

/** A league's table as text for people. */
public final class TableText {

    private static final int LONGEST_NAME = 30;
    private static final double HUNDRED = 100;
    /** More bots make a crosstable that is wider than a terminal. */
    private static final int WIDEST = 12;
    /** Width of the column of differences. */
    private static final int TO = 15;
    /** More would be a page of its own; 'table --json' has all. */
    private static final int SURPRISES = 10;

    private TableText() { }

    /** Everything: heading, table, crosstable, what the numbers mean. */
    public static List<String> whole(LeagueTable table, Season season, List<WorkerRow> workers, Colour colour) {
        List<String> lines = new ArrayList<>();
        lines.add(colour.strong(TextFormat.plain(TextFormat.count(table.results().games(), "game") + " of "
            + season.sceneName())) + others(table, workers));
        lines.add("");
        lines.addAll(rows(table, colour));
        int bots = table.rows().size();
        if (bots > 1 && bots <= WIDEST && table.results().games() > 0) {
            lines.add("");
            if (bots > 2) {
                lines.addAll(matrix(table, "% against", (row, column) -> HUNDRED * table.share(row, column)));
                lines.add("");
            }
            lines.addAll(matrix(table, "% better than",
                (row, column) -> HUNDRED * table.superiority(row, column)));
        }
        lines.add("");
        table.surprises().stream().limit(SURPRISES).forEach(each -> lines.add(surprise(table, each)));
        if (!workers.isEmpty()) {
            workers.forEach(worker -> lines.addAll(worker.lines()));
            lines.add("");
        }
        ApartWords.of(table).stream().limit(SURPRISES).map(TextFormat::plain).forEach(lines::add);
        lines.add("rating: Elo; 100 ahead takes 64 points of 100. " + zero(table));
        lines.add("bar: 95% interval, if the number of games was fixed before.");
        lines.add("anytime: 95% interval that holds however often you look.");
        lines.add(to(table) + ": the difference, with its bar.");
        lines.add("ranks: the ranks that are still possible, at 95%.");
        if (table.rows().stream().anyMatch(row -> !Double.isNaN(row.bound()) || row.difference().isOneSided())) {
            lines.add("> and <: bounds, of bots that have won or lost nearly everything.");
        }
        if (table.rows().stream().anyMatch(row -> row.sums().games() > 0 && Double.isNaN(row.bound())
                && !row.hasBar())) {
            lines.add("-: no rating, or too few games for a bar or a bound.");
        }
        if (season.players() == 1) {
            lines.add("Each bot plays alone; its score on a map is compared with the others' on the same map.");
        }
        if (table.rows().stream().anyMatch(row -> row.entry().random())) {
            lines.add("* uses random numbers: its games cannot be repeated exactly.");
        }
        return lines;
    }

    private static String others(LeagueTable table, List<WorkerRow> workers) {
        long again = table.results().playedAgain();
        long aside = workers.stream().mapToLong(WorkerRow::aside).sum();
        long suspended = workers.stream().filter(worker -> worker.state().equals(WorkerRow.SUSPENDED))
            .mapToLong(WorkerRow::aside).sum();
        long forgiven = table.results().forgiven();
        long without = table.results().withoutResult() - aside - forgiven;
        long repeats = table.results().repeats();
        return (repeats > 0 ? ", " + repeats + " more that only repeat earlier ones and do not count" : "")
            + (again > 0 ? ", " + again + " more played again since others used the processors" : "")
            + (aside > suspended ? ", " + (aside - suspended) + " more set aside, of workers that were caught" : "")
            + (suspended > 0 ? ", " + suspended + " more of workers that are suspended" : "")
            + (forgiven > 0 ? ", " + forgiven + " more forgiven" : "")
            + (without > 0 ? ", " + without + " more without a result" : "");
    }

    private static String zero(LeagueTable table) {
        return table.reference().anchor() < 0 ? "0 is the mean."
            : TextFormat.plain(table.name(table.reference().anchor())) + " is the anchor.";
    }

    /** Head of the column of differences. */
    private static String to(LeagueTable table) {
        int version = table.reference().compared();
        return version < 0 ? "to above" : "to " + TextFormat.plain(TextFormat.shorten(table.name(version), TO - 5));
    }

    private static String difference(Difference difference) {
        return difference.isOneSided() ? (difference.value() > 0 ? "> " : "< ") + Math.round(difference.boundElo())
            : Difference.isKnown(difference.bar()) ? signed(difference.elo()) + " " + bar(difference.bar()) : "-";
    }

    private static String name(Row row) {
        return TextFormat.plain(TextFormat.shorten(row.entry().name(), LONGEST_NAME))
            + (row.entry().random() ? "*" : "")
            + (row.entry().active() ? row.entry().paused() ? " (paused)" : "" : " (out)");
    }

    /** One line a bot, and their heads. */
    public static List<String> rows(LeagueTable table, Colour colour) {
        return new Table<Row>().right("  #", 3, row -> Integer.toString(row.rank())).left("bot", 1, TableText::name)
            .right("rating", 8, ofPlayed(row -> Double.isNaN(row.rating()) ? "-" : signed(row.rating())))
            .painted((row, word) -> colour.strong(word))
            .right("bar", 8, ofPlayed(row -> Double.isNaN(row.bound()) ? bar(row.bar()) : bound(row)))
            .right("anytime", 8, ofPlayed(row -> bar(row.anytime())))
            .right(to(table), TO, ofPlayed(row -> difference(row.difference())))
            .right("ranks", 7, ofPlayed(row -> row.best() + (row.best() == row.worst() ? "" : "-" + row.worst())))
            .right("games", 8, row -> Long.toString(row.sums().games()))
            .right("points", 8, row -> TextFormat.fixed(row.points(), 3))
            .right("faults", 8, row -> Long.toString(row.sums().faults()))
            .painted((row, word) -> row.sums().faults() > 0 ? colour.bad(word) : word)
            .right("all failed", 12, row -> Long.toString(row.sums().allFailed()))
            .right("mean ms", 9, row -> TextFormat.fixed(row.sums().meanNanos() / TextFormat.NANOS_PER_MS, 2))
            .right("worst ms", 10, ofPlayed(row -> TextFormat.ms(row.sums().worstNanos())))
            .right("mean score", 12, row -> TextFormat.fixed(row.sums().meanScore(), 2)).lines(table.rows());
    }

    /** A dash for a bot without games. */
    private static Function<Row, String> ofPlayed(Function<Row, String> text) {
        return row -> row.sums().games() > 0 ? text.apply(row) : "-";
    }

    /** A pair whose games say something else than the ratings. */
    public static String surprise(LeagueTable table, LeagueTable.Surprise each) {
        double share = HUNDRED * each.residual().share();
        double expected = HUNDRED * each.residual().expected();
        int digits = Math.round(share) == Math.round(expected) ? 1 : 0;
        return name(table.rows().get(each.row())) + " beats " + name(table.rows().get(each.column()))
            + " more than ratings tell: " + TextFormat.fixed(share, digits) + "% of "
            + TextFormat.count(Math.round(table.games(each.row(), each.column())), "game") + ", where they tell "
            + TextFormat.fixed(expected, digits) + "%.";
    }

    private static String bar(double bar) {
        return Difference.isKnown(bar) ? "± " + Math.round(bar) : "-";
    }

    /** One end of a bar that has no other. */
    private static String bound(Row row) {
        return (row.bound() < row.rating() ? "> " : "< ") + Math.round(row.bound());
    }

    private static String signed(double rating) {
        return String.format(Locale.ROOT, "%+d", Math.round(rating));
    }

    private interface Cell {
        double percent(int row, int column);
    }

    /** A number of percent for every two bots, by rank. */
    private static List<String> matrix(LeagueTable table, String title, Cell cell) {
        Table<Integer> matrix = new Table<Integer>().left("  " + title + "  ", 0, row ->
            TextFormat.right(Integer.toString(row + 1), 3) + " " + name(table.rows().get(row)));
        int bots = table.rows().size();
        for (int k = 0; k < bots; k++) {
            int column = k;
            matrix.right("#" + (k + 1), 5, row -> {
                double percent = row == column ? Double.NaN : cell.percent(row, column);
                return row == column ? "." : Double.isNaN(percent) ? "-" : Long.toString(Math.round(percent));
            });
        }
        return matrix.lines(IntStream.range(0, bots).boxed().toList());
    }
}
