package steward.league.page;

import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.IntStream;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.rating.Difference;
import steward.league.rating.LeagueTable;
import steward.league.rating.LeagueTable.Row;
import steward.league.rating.RatingPath;
import tools.jackson.core.JsonGenerator;

/** League as JSON, for programs and for its own page. */
public final class LeagueJson {

    private static final double NANOS_PER_MS = 1e6;
    /** Bots up to which all differences are told: each takes time by the number of pairings, all of them bots^4. */
    private static final int MOST_ALL = 100;
    /** Places above and below a bot to which its differences are told of more bots. */
    private static final int NEAR = 10;

    private LeagueJson() { }

    /** The fields of the table: the season, games, bots by rank, and the crosstable by the same order, workers. */
    public static void table(JsonGenerator out, Season season, LeagueTable table, List<WorkerRow> workers) {
        out.writeStringProperty("scene", season.sceneName());
        out.writeStringProperty("sceneKey", season.sceneKey());
        out.writeStringProperty("limits", season.limits());
        out.writeNumberProperty("players", season.players());
        out.writeNumberProperty("games", table.results().games());
        out.writeNumberProperty("repeats", table.results().repeats());
        out.writeNumberProperty("again", table.results().playedAgain());
        out.writeNumberProperty("without", table.results().withoutResult());
        out.writeNumberProperty("forgiven", table.results().forgiven());
        out.writeName("anchor");
        if (table.reference().anchor() < 0) {
            out.writeNull();
        } else {
            out.writeStartArray();
            out.writeString(table.name(table.reference().anchor()));
            JsonNumbers.write(out, table.reference().elo());
            out.writeEndArray();
        }
        JsonObject.writeAll(out, "bots", table.rows(), row -> bot(out, table, row));
        JsonObject.writeTexts(out, "apart", ApartWords.of(table));
        square(out, "cross", table, (row, column) -> cell(out, table, row, column));
        square(out, "differences", table, (row, column) -> difference(out, table, row, column));
        JsonObject.writeEach(out, "surprises", table.surprises(), each -> {
            out.writeStartArray();
            out.writeNumber(each.row());
            out.writeNumber(each.column());
            JsonNumbers.write(out, each.residual().share());
            JsonNumbers.write(out, each.residual().expected());
            JsonNumbers.write(out, each.residual().z());
            out.writeEndArray();
        });
        if (!workers.isEmpty()) {
            JsonObject.writeAll(out, "workers", workers, worker -> worker(out, worker));
        }
    }

    private static void square(JsonGenerator out, String name, LeagueTable table,
                               BiConsumer<Integer, Integer> cell) {
        JsonObject.writeEach(out, name, table.rows().size(), row -> {
            out.writeStartArray();
            IntStream.range(0, table.rows().size()).forEach(column -> cell.accept(row, column));
            out.writeEndArray();
        });
    }

    private static void worker(JsonGenerator out, WorkerRow worker) {
        out.writeStringProperty("name", worker.name());
        out.writeStringProperty("state", worker.state());
        out.writeNumberProperty("games", worker.games());
        out.writeNumberProperty("aside", worker.aside());
        JsonNumbers.writeOrNull(out, "rate", worker.rate());
        out.writeNumberProperty("faults", worker.faults());
        out.writeNumberProperty("repeated", worker.repeated());
        out.writeStringProperty("program", worker.version());
        out.writeNumberProperty("silentMs", worker.silentMs());
        JsonObject.writeTexts(out, "doubts", worker.doubts());
    }

    /**
     * In Elo: the difference, its bar, the bar that holds at all looks; the likelihood of superiority; and the end of a
     * bar that has only one, or {@code null}. What is not known is {@code null}: of bots that cannot be compared all
     * but the likelihood and the bound. Of more than 100 bots those more than 10 places apart are {@code null}.
     */
    private static void difference(JsonGenerator out, LeagueTable table, int row, int column) {
        if (row == column || table.rows().size() > MOST_ALL && Math.abs(row - column) > NEAR) {
            out.writeNull();
            return;
        }
        difference(out, table.bounded(row, column), table.superiority(row, column));
    }

    private static void difference(JsonGenerator out, Difference difference, double superiority) {
        out.writeStartArray();
        JsonNumbers.writeOrNull(out, Double.isInfinite(difference.elo()) ? Double.NaN : difference.elo());
        for (double bar : new double[] {difference.isOneSided() ? Difference.MOST_BAR : difference.bar(),
            difference.anytimeBar()}) {
            JsonNumbers.writeOrNull(out, known(bar));
        }
        JsonNumbers.writeOrNull(out, superiority);
        JsonNumbers.writeOrNull(out, difference.isOneSided() ? difference.boundElo() : Double.NaN);
        out.writeEndArray();
    }

    private static void cell(JsonGenerator out, LeagueTable table, int row, int column) {
        if (row == column || !(table.games(row, column) > 0)) {
            out.writeNull();
            return;
        }
        out.writeStartArray();
        JsonNumbers.write(out, table.share(row, column));
        JsonNumbers.write(out, table.games(row, column));
        out.writeEndArray();
    }

    private static double known(double bar) {
        return Difference.isKnown(bar) ? bar : Double.NaN;
    }

    private static void bot(JsonGenerator out, LeagueTable table, Row row) {
        out.writeNumberProperty("rank", row.rank());
        out.writeNumberProperty("version", row.entry().version());
        out.writeStringProperty("name", row.entry().name());
        out.writeBooleanProperty("active", row.entry().active());
        out.writeBooleanProperty("random", row.entry().random());
        out.writeBooleanProperty("paused", row.entry().active() && row.entry().paused());
        out.writeNumberProperty("group", row.component());
        JsonNumbers.writeOrNull(out, "rating", row.rating());
        JsonNumbers.writeOrNull(out, "bar", row.hasBar() ? row.bar() : Double.NaN);
        JsonNumbers.writeOrNull(out, "bound", row.bound());
        JsonNumbers.writeOrNull(out, "anytime", known(row.anytime()));
        out.writeStringProperty("to", row.to() < 0 ? null : table.name(row.to()));
        out.writeName("difference");
        difference(out, row.difference(), row.to() < 0 ? Double.NaN
            : table.ratings().superiority(row.entry().version(), row.to()));
        out.writeNumberProperty("best", row.best());
        out.writeNumberProperty("worst", row.worst());
        out.writeNumberProperty("games", row.sums().games());
        JsonNumbers.writeOrNull(out, "points", row.points());
        JsonNumbers.writeOrNull(out, "wins", row.wins());
        JsonNumbers.writeOrNull(out, "draws", row.draws());
        JsonNumbers.writeOrNull(out, "losses", row.losses());
        out.writeNumberProperty("faults", row.sums().faults());
        out.writeNumberProperty("allFailed", row.sums().allFailed());
        JsonNumbers.writeOrNull(out, "score", row.sums().meanScore());
        JsonNumbers.writeOrNull(out, "meanMs", row.sums().meanNanos() / NANOS_PER_MS);
        JsonNumbers.writeOrNull(out, "worstMs",
            row.sums().games() == 0 ? Double.NaN : row.sums().worstNanos() / NANOS_PER_MS);
    }

    /**
     * Everything that the page shows, as fields.
     *
     * @param replay how the replay of a game is to be had: {@code live}, {@code page}, or its file; {@code null} for
     *               none
     * @param errors lines of stderr that say why bots failed
     */
    static void view(JsonGenerator out, LeagueView view, Function<StoredGame, String> replay, ErrorLines errors) {
        table(out, view.season(), view.table(), view.workers());
        JsonNumbers.writeOrNull(out, "rate", view.rate());
        path(out, view.path());
        out.writeObjectPropertyStart("why");
        new TreeMap<>(view.why()).forEach((version, lines) ->
            JsonObject.writeTexts(out, Integer.toString(version), lines));
        out.writeEndObject();
        JsonObject.writeAll(out, "list", view.games(), game -> game(out, game, replay.apply(game), errors));
    }

    private static void path(JsonGenerator out, RatingPath path) {
        out.writeObjectPropertyStart("path");
        JsonObject.writeEach(out, "versions", path.entries(), entry -> out.writeNumber(entry.version()));
        JsonObject.writeAll(out, "points", path.points(), point -> {
            out.writeNumberProperty("games", point.games());
            numbers(out, "ratings", point.ratings());
            numbers(out, "bars", Arrays.stream(point.bars()).map(LeagueJson::known).toArray());
        });
        out.writeEndObject();
    }

    private static void numbers(JsonGenerator out, String name, double... values) {
        out.writeArrayPropertyStart(name);
        for (double value : values) {
            JsonNumbers.writeOrNull(out, Math.rint(value * 10) / 10);
        }
        out.writeEndArray();
    }

    private static void game(JsonGenerator out, StoredGame game, String replay, ErrorLines errors) {
        out.writeNumberProperty("id", game.id());
        out.writeStringProperty("seed", Long.toString(game.seed()));
        out.writeNumberProperty("turns", game.turns());
        out.writeBooleanProperty("counts", game.counts());
        out.writeStringProperty("problem", game.problem());
        out.writeStringProperty("replay", replay);
        JsonObject.writeAll(out, "seats", game.seats().size(), number -> {
            StoredGame.StoredSeat seat = game.seats().get(number);
            out.writeNumberProperty("version", seat.version());
            out.writeNumberProperty("rank", seat.rank());
            JsonNumbers.writeOrNull(out, "score", seat.score());
            out.writeStringProperty("fault", seat.fault());
            out.writeStringProperty("error", errors.of(game, number));
        });
    }
}
