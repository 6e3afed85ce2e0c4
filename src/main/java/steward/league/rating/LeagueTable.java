package steward.league.rating;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The table of a season: one row for each version of a bot, best first, and who beat whom.
 *
 * @param rows    by rating
 * @param results what they are computed from
 */
public record LeagueTable(List<Row> rows, Results results) {

    /**
     * A version of a bot that may have a row.
     *
     * @param version its number in the store
     * @param name    of the bot, with the number of the version from the second on
     * @param random  whether the bot draws by lot
     * @param active  whether it plays
     */
    public record Entry(int version, String name, boolean random, boolean active) {
    }

    /**
     * A row.
     *
     * @param rank   from 1; equal ratings share one
     * @param entry  whose it is
     * @param rating in Elo, 0 is the mean by games
     * @param bar    half the width of its 95% bar
     * @param points share of the points, 0..1; NaN without games
     * @param wins   games won, in whole games of two
     * @param draws  games drawn, likewise
     * @param losses games lost, likewise
     * @param sums   games, score, faults, answer times
     */
    public record Row(int rank, Entry entry, double rating, double bar, double points, double wins, double draws,
                      double losses, BotSums sums) {
    }

    /** Copies the list. */
    public LeagueTable {
        rows = List.copyOf(rows);
    }

    /** Rates those entries that have games or play. */
    public static LeagueTable of(Results results, List<Entry> entries) {
        List<Entry> shown = entries.stream()
            .filter(entry -> entry.active() || results.of(entry.version()).games() > 0).toList();
        int bots = shown.size();
        double[][] points = new double[bots][bots];
        double[][] games = new double[bots][bots];
        for (int i = 0; i < bots; i++) {
            for (int j = 0; j < bots; j++) {
                if (i != j) {
                    points[i][j] = results.points(shown.get(i).version(), shown.get(j).version());
                    games[i][j] = results.games(shown.get(i).version(), shown.get(j).version());
                }
            }
        }
        BradleyTerry fit = BradleyTerry.fit(points, games);
        List<Integer> order = IntStream.range(0, bots).boxed()
            .sorted(Comparator.comparingDouble((Integer bot) -> -fit.rating(bot))
                .thenComparing(bot -> shown.get(bot).version())).toList();
        List<Row> rows = new ArrayList<>();
        for (int place = 0; place < bots; place++) {
            int bot = order.get(place);
            Row above = place == 0 ? null : rows.get(place - 1);
            int rank = above != null && above.rating() == fit.rating(bot) ? above.rank() : place + 1;
            rows.add(row(rank, shown, bot, fit, results));
        }
        return new LeagueTable(rows, results);
    }

    private static Row row(int rank, List<Entry> shown, int bot, BradleyTerry fit, Results results) {
        double games = 0;
        double points = 0;
        double wins = 0;
        double draws = 0;
        int version = shown.get(bot).version();
        for (Entry other : shown) {
            if (other.version() != version) {
                games += results.games(version, other.version());
                points += results.points(version, other.version());
                wins += results.wins(version, other.version());
                draws += results.draws(version, other.version());
            }
        }
        return new Row(rank, shown.get(bot), fit.rating(bot), fit.bar(bot), points / games, wins, draws,
            games - wins - draws, results.of(version));
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
}
