package steward.league.rating;

import java.util.ArrayList;
import java.util.List;

/**
 * History of the ratings: the table after each of several numbers of games.
 *
 * @param points in the order of time
 */
public record RatingPath(List<LeagueTable.Entry> entries, List<Point> points) {

    /** Points that are drawn of few bots. */
    public static final int MOST = 60;
    private static final long LEAST = 4;
    /** Bots of which {@link #MOST} fits take a second or two; the time of a fit grows as the cube of their number. */
    private static final double QUICK = 100;

    /** Number of points drawn for so many bots: fewer where they are many. */
    public static long points(int bots) {
        double share = Math.min(1, QUICK / bots);
        return Math.max(LEAST, Math.round(MOST * share * share * share));
    }

    /**
     * The ratings after some games.
     *
     * @param games   how many counted
     * @param ratings by entry, in Elo; NaN for those without games
     * @param bars    likewise
     */
    public record Point(long games, double[] ratings, double... bars) { }

    /** Collects points. */
    public static final class Collector {

        private final List<LeagueTable.Entry> entries;
        private final LeagueTable.Reference reference;
        private final List<Point> points = new ArrayList<>();

        /** @param entries the versions to follow */
        public Collector(List<LeagueTable.Entry> entries, LeagueTable.Reference reference) {
            this.entries = List.copyOf(entries);
            this.reference = reference;
        }

        /** Takes the results as they are now. */
        public void take(Results results) {
            List<Integer> rated = entries.stream().map(LeagueTable.Entry::version)
                .filter(version -> results.of(version).games() > 0).toList();
            Ratings table = Ratings.of(results, rated);
            double[] ratings = new double[entries.size()];
            double[] bars = new double[entries.size()];
            for (int k = 0; k < entries.size(); k++) {
                boolean known = rated.contains(entries.get(k).version());
                Difference rating = known ? table.anchored(entries.get(k).version(), reference.anchor())
                    : Difference.NONE;
                boolean isAnchored = known && rated.contains(reference.anchor())
                    && table.isComparable(entries.get(k).version(), reference.anchor());
                ratings[k] = rating.elo() + (isAnchored ? reference.elo() : 0);
                bars[k] = rating.isOneSided() ? Double.NaN : rating.bar();
            }
            points.add(new Point(results.games(), ratings, bars));
        }

        /** The path so far. */
        public RatingPath path() {
            return new RatingPath(entries, List.copyOf(points));
        }
    }
}
