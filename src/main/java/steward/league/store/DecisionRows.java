package steward.league.store;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import steward.league.Decision;

/**
 * Writer of rows of decisions within a running transaction. Not thread-safe.
 *
 * @param lineups the table of that name
 */
record DecisionRows(Database database, TextRows lineups) {

    void add(int season, Decision.News news) {
        news.made().forEach(each -> add(season, each));
        news.dropped().forEach((number, is) -> RowDigest.sealed(database, "decision", "UPDATE decision SET dropped = ? "
            + "WHERE season = ? AND number = ?", is ? 1 : 0, season, number));
    }

    private void add(int season, Decision decision) {
        Object[] row = {season, decision.number(), decision.seed(), lineups.number(text(decision.group())),
            decision.paused().isEmpty() ? null : text(decision.paused()), 0, 0L};
        row[row.length - 1] = RowDigest.of(Arrays.copyOf(row, row.length - 1));
        database.update("INSERT INTO decision (season, number, seed, lineup, paused, dropped, digest) "
            + "VALUES (?, ?, ?, ?, ?, ?, ?)", row);
    }

    private static String text(List<Integer> versions) {
        StringBuilder text = new StringBuilder();
        versions.forEach(version -> text.append(text.length() == 0 ? "" : " ").append(version));
        return text.toString();
    }

    /**
     * Adds one for each decision that has games but no row: its first game says on which seed and who plays; where each
     * plays alone, all of its games do. Games that {@link RowCheck} refuses are passed over.
     */
    void ofGames() {
        List<Runnable> found = new ArrayList<>();
        database.each("SELECT s.id, g.decision, g.seed, iif(s.players = 1, group_concat(l.versions, ' '), l.versions), "
            + "min(g.id) FROM game g JOIN season s ON s.id = g.season JOIN lineup l ON l.id = g.lineup WHERE "
            + "l.versions NOT GLOB '*[^0-9 ]*' AND typeof(g.decision) = 'integer' AND g.decision BETWEEN 0 AND "
            + "2147483647 AND typeof(g.seed) = 'integer' AND NOT EXISTS (SELECT 1 FROM decision o WHERE o.season = "
            + "g.season AND o.number = g.decision) GROUP BY s.id, g.decision", row -> {
                String versions = row.getString(4);
                if (versions != null && RowCheck.VERSIONS.matcher(versions).matches()) {
                    int season = row.getInt(1);
                    Decision decision = new Decision(row.getInt(2), row.getLong(3), Arrays.stream(GameQueries
                        .numbers(versions)).sorted().distinct().boxed().toList(), List.of());
                    found.add(() -> add(season, decision));
                }
            });
        found.forEach(Runnable::run);                  // rows that are being read do not change
    }
}
