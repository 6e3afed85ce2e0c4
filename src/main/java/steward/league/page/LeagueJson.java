package steward.league.page;

import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.function.Function;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.rating.Difference;
import steward.league.rating.LeagueTable;
import steward.league.rating.LeagueTable.Row;
import steward.report.Fields;
import steward.report.Table;
import steward.text.TextFormat;

/** League as JSON, for programs and for its own page. */
public final class LeagueJson {

    /** Bots up to which all differences are told: each takes time by the number of pairings, all of them bots^4. */
    private static final int MOST_ALL = 100;
    /** Places above and below a bot to which its differences are told of more bots. */
    private static final int NEAR = 10;

    private LeagueJson() { }

    /** The table: the season, games, bots by rank, and the crosstable by the same order, workers. */
    public static Fields table(Season season, LeagueTable table, List<WorkerRow> workers) {
        int anchor = table.reference().anchor();
        Fields fields = Fields.of("scene", season.sceneName(), "sceneKey", season.sceneKey(),
            "limits", season.limits(), "players", season.players(), "games", table.results().games(),
            "repeats", table.results().repeats(), "again", table.results().playedAgain(),
            "without", table.results().withoutResult(), "forgiven", table.results().forgiven(),
            "anchor", anchor < 0 ? null : List.of(table.name(anchor), table.reference().elo()),
            "bots", bots(table, false).json(table.rows()), "apart", ApartWords.of(table),
            "cross", square(table, (row, column) -> cell(table, row, column)),
            "differences", square(table, (row, column) -> difference(table, row, column)),
            "surprises", Fields.each(table.surprises(), each -> List.of(each.row(), each.column(),
                each.residual().share(), each.residual().expected(), each.residual().z())));
        return workers.isEmpty() ? fields : fields.with("workers", Fields.each(workers, worker -> Fields.of(
            "name", worker.name(), "state", worker.state(), "games", worker.games(), "aside", worker.aside(),
            "rate", worker.rate(), "faults", worker.faults(), "repeated", worker.repeated(),
            "program", worker.version(), "silentMs", worker.silentMs(), "doubts", worker.doubts())));
    }

    private static Iterable<Object> square(LeagueTable table, BiFunction<Integer, Integer, Object> cell) {
        int bots = table.rows().size();
        return Fields.each(bots, row -> Fields.each(bots, column -> cell.apply(row, column)));
    }

    /**
     * In Elo: the difference, its bar, the bar that holds at all looks; the likelihood of superiority; and the end of a
     * bar that has only one, or {@code null}. What is not known is {@code null}: of bots that cannot be compared all
     * but the likelihood and the bound. Of more than 100 bots those more than 10 places apart are {@code null}.
     */
    private static Object difference(LeagueTable table, int row, int column) {
        return row == column || table.rows().size() > MOST_ALL && Math.abs(row - column) > NEAR ? null
            : difference(table.bounded(row, column), table.superiority(row, column));
    }

    private static Object difference(Difference difference, double superiority) {
        return List.of(difference.elo(), difference.isOneSided() ? Double.NaN : known(difference.bar()),
            known(difference.anytimeBar()), superiority, difference.isOneSided() ? difference.boundElo() : Double.NaN);
    }

    private static Object cell(LeagueTable table, int row, int column) {
        return row == column || !(table.games(row, column) > 0) ? null
            : List.of(table.share(row, column), table.games(row, column));
    }

    private static double known(double bar) {
        return Difference.isKnown(bar) ? bar : Double.NaN;
    }

    /**
     * Columns of the table of bots.
     *
     * @param flat whether a difference takes several columns, as in CSV, and is no array
     */
    public static Table<Row> bots(LeagueTable table, boolean flat) {
        Table<Row> bots = new Table<Row>().value("rank", Row::rank);
        Function<Row, Object> version = row -> row.entry().version();
        if (flat) {
            bots.value("bot", row -> row.entry().name()).value("version", version);
        } else {
            bots.value("version", version).value("name", row -> row.entry().name());
        }
        bots.value("active", row -> row.entry().active()).value("random", row -> row.entry().random());
        if (!flat) {
            bots.value("paused", row -> row.entry().active() && row.entry().paused());
        }
        bots.value("group", Row::component).value("rating", Row::rating)
            .value("bar", row -> row.hasBar() ? row.bar() : Double.NaN).value("bound", Row::bound)
            .value("anytime", row -> known(row.anytime()))
            .value("to", row -> row.to() < 0 ? null : table.name(row.to()));
        if (flat) {
            bots.value("difference", row -> row.difference().elo())
                .value("differenceBar", row -> row.difference().isOneSided() ? Double.NaN
                    : known(row.difference().bar()))
                .value("differenceBound", row -> row.difference().boundElo())
                .value("differenceAnytime", row -> known(row.difference().anytimeBar()));
        } else {
            bots.value("difference", row -> difference(row.difference(), row.to() < 0 ? Double.NaN
                : table.ratings().superiority(row.entry().version(), row.to())));
        }
        return bots.value("best", Row::best).value("worst", Row::worst).value("games", row -> row.sums().games())
            .value("points", Row::points).value("wins", Row::wins).value("draws", Row::draws)
            .value("losses", Row::losses).value("faults", row -> row.sums().faults())
            .value("allFailed", row -> row.sums().allFailed()).value("score", row -> row.sums().meanScore())
            .value("meanMs", row -> row.sums().meanNanos() / TextFormat.NANOS_PER_MS)
            .value("worstMs", row -> row.sums().games() == 0 && !flat ? Double.NaN
                : row.sums().worstNanos() / TextFormat.NANOS_PER_MS);
    }

    /**
     * Everything that the page shows.
     *
     * @param replay how the replay of a game is to be had: {@code live}, {@code page}, or its file; {@code null} for
     *               none
     * @param errors lines of stderr that say why bots failed
     */
    static Fields view(LeagueView view, Function<StoredGame, String> replay, ErrorLines errors) {
        return table(view.season(), view.table(), view.workers()).with("rate", view.rate(),
            "path", Fields.of("versions", Fields.each(view.path().entries(), LeagueTable.Entry::version),
                "points", Fields.each(view.path().points(), point -> Fields.of("games", point.games(),
                    "ratings", numbers(point.ratings()),
                    "bars", numbers(Arrays.stream(point.bars()).map(LeagueJson::known).toArray())))),
            "why", new TreeMap<>(view.why()),
            "list", Fields.each(view.games(), game -> game(game, replay.apply(game), errors)));
    }

    private static List<Double> numbers(double... values) {
        return Arrays.stream(values).mapToObj(value -> Math.rint(value * 10) / 10).toList();
    }

    private static Fields game(StoredGame game, String replay, ErrorLines errors) {
        return Fields.of("id", game.id(), "seed", Long.toString(game.seed()), "turns", game.turns(),
            "counts", game.counts(), "problem", game.problem(), "replay", replay,
            "seats", Fields.each(game.seats().size(), number -> {
                StoredGame.StoredSeat seat = game.seats().get(number);
                return Fields.of("version", seat.version(), "rank", seat.rank(), "score", seat.score(),
                    "fault", seat.fault(), "error", errors.of(game, number));
            }));
    }
}
