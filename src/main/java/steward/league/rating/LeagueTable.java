package steward.league.rating;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The table of a season: one row for each version of a bot, best first, and who beat whom.
 *
 * @param rows    by rating
 * @param results what they are computed from
 * @param ratings of all rows
 */
public record LeagueTable(List<Row> rows, Results results, Ratings ratings) {

    /**
     * A version of a bot that may have a row.
     *
     * @param version its number in the store
     * @param name    of the bot, with the number of the version from the second on
     * @param random  whether the bot draws by lot
     * @param active  whether it plays
     * @param paused  whether it was paused when the league was last played
     */
    public record Entry(int version, String name, boolean random, boolean active, boolean paused) {

        /** A version that is not paused. */
        public Entry(int version, String name, boolean random, boolean active) {
            this(version, name, random, active, false);
        }
    }

    /**
     * A row.
     *
     * @param rank   from 1; equal ratings share one
     * @param best   the best rank that the games leave it, with 95%
     * @param rating in Elo, 0 is the mean by games
     * @param bar    half the width of its 95% bar at a number of games that was fixed before
     * @param bound  where the bar has one side, since the bot has won or lost nearly everything: its end; otherwise NaN
     * @param anytime half the width of its 95% bar that holds at all looks at once
     * @param points share of the points, 0..1; NaN without games
     * @param wins   games won, in whole games of two
     * @param draws  games drawn, likewise
     * @param losses games lost, likewise
     * @param sums   games, score, faults, answer times
     */
    public record Row(int rank, int best, int worst, Entry entry, double rating, double bar, double bound,
                      double anytime, double points, double wins, double draws, double losses, BotSums sums) {

        /** True if the bar has two sides and says anything. */
        public boolean hasBar() {
            return Double.isNaN(bound) && Difference.isKnown(bar);
        }
    }

    public LeagueTable {
        rows = List.copyOf(rows);
    }

    /** Rates those entries that have games or play. */
    public static LeagueTable of(Results results, List<Entry> entries) {
        List<Entry> shown = entries.stream()
            .filter(entry -> entry.active() || results.of(entry.version()).games() > 0).toList();
        Ratings ratings = Ratings.of(results, shown.stream().map(Entry::version).toList());
        Map<Entry, Difference> found = new HashMap<>();
        shown.forEach(entry -> found.put(entry, ratings.bounded(entry.version())));
        List<Entry> order = shown.stream().sorted(Comparator.comparingDouble((Entry entry) -> -found.get(entry).elo())
            .thenComparing(Entry::version)).toList();
        List<RankRange> ranks = ratings.ranks();
        Map<Integer, double[]> met = results.sumsOver(ratings.versions());
        List<Row> rows = new ArrayList<>();
        for (Entry entry : order) {
            Row above = rows.isEmpty() ? null : rows.get(rows.size() - 1);
            int rank = above != null && above.rating() == found.get(entry).elo() ? above.rank() : rows.size() + 1;
            int place = ratings.versions().indexOf(entry.version());
            rows.add(row(rank, entry, ranks.get(place), found.get(entry), results, met.get(entry.version())));
        }
        return new LeagueTable(rows, results, ratings);
    }

    private static Row row(int rank, Entry entry, RankRange ranks, Difference rating, Results results,
                           double... met) {
        int version = entry.version();
        return new Row(rank, ranks.best(), ranks.worst(), entry, rating.elo(), rating.bar(),
            rating.boundElo(), rating.anytimeBar(),
            met[0] / met[1], met[2], met[3], met[1] - met[2] - met[3], results.of(version));
    }

    /** Share of the points of the row's bot against the column's, by their places; NaN if they have not met. */
    public double share(int row, int column) {
        int one = rows.get(row).entry().version();
        int other = rows.get(column).entry().version();
        return results.points(one, other) / results.games(one, other);
    }

    /** Games between the bots of two rows. */
    public double games(int row, int column) {
        return results.games(rows.get(row).entry().version(), rows.get(column).entry().version());
    }

    public Difference difference(int row, int column) {
        return ratings.difference(rows.get(row).entry().version(), rows.get(column).entry().version());
    }

    /** Difference with a bound in place of a bar where one has won or lost nearly everything, of up to 30 bots. */
    public Difference bounded(int row, int column) {
        return ratings.bounded(rows.get(row).entry().version(), rows.get(column).entry().version());
    }

    /** Returns the residual of the games of two rows beside their ratings. */
    public Residual residual(int row, int column) {
        return ratings.residual(rows.get(row).entry().version(), rows.get(column).entry().version());
    }

    /**
     * A pair of rows whose games say something else than their ratings.
     *
     * @param row    whose bot wins more than the ratings tell
     * @param column against whose
     */
    public record Surprise(int row, int column, Residual residual) { }

    /** All pairs whose games say something else, the surest first. */
    public List<Surprise> surprises() {
        List<Surprise> surprises = new ArrayList<>();
        int pairs = rows.size() * (rows.size() - 1) / 2;
        for (int row = 0; row < rows.size(); row++) {
            for (int column = 0; column < rows.size(); column++) {
                if (row != column && games(row, column) > 0) {
                    Residual residual = residual(row, column);
                    if (residual.z() > 0 && residual.isSurprise(pairs)) {
                        surprises.add(new Surprise(row, column, residual));
                    }
                }
            }
        }
        surprises.sort(Comparator.comparingDouble((Surprise each) -> -each.residual().z())
            .thenComparing(Surprise::row).thenComparing(Surprise::column));
        return surprises;
    }
}
