package steward.league.rating;

import java.util.ArrayList;
import java.util.List;

/**
 * How the ratings went while games were played: the table after each of some numbers of games.
 *
 * @param entries the versions
 * @param points  in the order of time
 */
public record RatingPath(List<LeagueTable.Entry> entries, List<Point> points) {

    /** How many points are drawn at most. */
    public static final int MOST = 60;

    /**
     * The ratings after some games.
     *
     * @param games   how many counted
     * @param ratings by entry, in Elo; NaN for those without games
     * @param bars    likewise
     */
    public record Point(long games, double[] ratings, double... bars) {
    }

    /** Collects points. */
    public static final class Collector {

        private final List<LeagueTable.Entry> entries;
        private final List<Point> points = new ArrayList<>();

        /** @param entries the versions to follow */
        public Collector(List<LeagueTable.Entry> entries) {
            this.entries = List.copyOf(entries);
        }

        /** Takes the results as they are now. */
        public void take(Results results) {
            LeagueTable table = LeagueTable.of(results, entries);
            double[] ratings = new double[entries.size()];
            double[] bars = new double[entries.size()];
            for (int k = 0; k < entries.size(); k++) {
                LeagueTable.Entry entry = entries.get(k);
                LeagueTable.Row row = table.rows().stream().filter(each -> each.entry().equals(entry)
                    && each.sums().games() > 0).findFirst().orElse(null);
                ratings[k] = row == null ? Double.NaN : row.rating();
                bars[k] = row == null ? Double.NaN : row.bar();
            }
            points.add(new Point(results.games(), ratings, bars));
        }

        /** The path so far. */
        public RatingPath path() {
            return new RatingPath(entries, List.copyOf(points));
        }
    }
}
