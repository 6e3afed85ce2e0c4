package steward.league.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import steward.league.Decision;
import steward.league.StoredGame;

/** Writes the rows of decisions, within a transaction that has begun. Not thread-safe. */
final class DecisionRows {

    private final Database database;
    private final TextRows lineups;

    /** @param lineups the table of that name */
    DecisionRows(Database database, TextRows lineups) {
        this.database = database;
        this.lineups = lineups;
    }

    void add(int season, Decision.News news) throws SQLException {
        for (Decision each : news.made()) {
            add(season, each.number(), each.seed(), each.group(), each.paused().isEmpty() ? null : text(each.paused()));
        }
        for (Map.Entry<Integer, Boolean> each : news.dropped().entrySet()) {
            database.update("UPDATE decision SET dropped = ? WHERE season = ? AND number = ?",
                each.getValue() ? 1 : 0, season, each.getKey());
            RowDigest.seal(database, "decision", "season = ? AND number = ?", season, each.getKey());
        }
    }

    private void add(int season, int number, long seed, Collection<Integer> group, String paused) throws SQLException {
        Object[] row = {season, number, seed, lineups.number(text(group)), paused, 0, 0L};
        row[row.length - 1] = RowDigest.of(Arrays.copyOf(row, row.length - 1));
        database.update("INSERT INTO decision (season, number, seed, lineup, paused, dropped, digest) "
            + "VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT (season, number) DO NOTHING", row);
    }

    static String text(Collection<Integer> versions) {
        return versions.stream().map(Object::toString).collect(Collectors.joining(" "));
    }

    /** A decision that is known by its games: its seed and its versions. */
    private record Known(long seed, TreeSet<Integer> group) {

        void add(int... versions) {
            if (versions.length == 1 || group.isEmpty()) {
                Arrays.stream(versions).forEach(group::add);
            }
        }
    }

    /** Adds those of games that come from elsewhere, unless they are there. */
    void ofGames(int season, List<StoredGame> games) throws SQLException {
        Map<Integer, Known> found = new TreeMap<>();
        for (StoredGame game : games) {
            if (game.decision() >= 0) {
                found.computeIfAbsent(game.decision(), number -> new Known(game.seed(), new TreeSet<>()))
                    .add(game.lineup());
            }
        }
        add(season, found);
    }

    private void add(int season, Map<Integer, Known> found) throws SQLException {
        for (Map.Entry<Integer, Known> each : found.entrySet()) {
            add(season, each.getKey(), each.getValue().seed(), each.getValue().group(), null);
        }
    }

    /** Adds one for each decision that has games but no row; what {@link RowCheck} refuses of them is passed over. */
    void ofGames() throws SQLException {
        Map<Long, int[]> versions = new HashMap<>();
        try (ResultSet row = database.query("SELECT id, versions FROM lineup WHERE typeof(versions) = 'text'")) {
            while (row.next()) {
                if (RowCheck.VERSIONS.matcher(row.getString(2)).matches()) {
                    versions.put(row.getLong(1), GameQueries.numbers(row.getString(2)));
                }
            }
        }
        Map<Integer, Map<Integer, Known>> found = new TreeMap<>();
        try (ResultSet row = database.query("SELECT season, decision, seed, lineup FROM game WHERE season IN (SELECT "
            + "id FROM season) AND typeof(decision) = 'integer' AND decision BETWEEN 0 AND 2147483647 AND typeof(seed) "
            + "= 'integer' AND NOT EXISTS (SELECT 1 FROM decision o WHERE o.season = game.season AND o.number = "
            + "decision)")) {
            while (row.next()) {
                int[] lineup = versions.get(row.getLong(4));
                long seed = row.getLong(3);
                if (lineup != null) {
                    found.computeIfAbsent(row.getInt(1), season -> new TreeMap<>()).computeIfAbsent(row.getInt(2),
                        number -> new Known(seed, new TreeSet<>())).add(lineup);
                }
            }
        }
        for (Map.Entry<Integer, Map<Integer, Known>> season : found.entrySet()) {
            add(season.getKey(), season.getValue());
        }
    }
}
