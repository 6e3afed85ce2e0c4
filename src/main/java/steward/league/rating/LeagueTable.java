package steward.league.rating;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;

/**
 * The table of a season: one row for each version of a bot, best first, and the crosstable of results.
 *
 * @param rows      by component, see {@link Components}, and rating
 * @param results   what they are computed from
 * @param ratings   of all rows
 * @param reference what they are told against
 */
public record LeagueTable(List<Row> rows, Results results, Ratings ratings, Reference reference) {

    /**
     * Bots against which ratings and differences are told.
     *
     * @param anchor  version whose rating is given, or -1: then the mean of each component is 0
     * @param elo     the rating of the anchor
     * @param against version to which differences are told, or -1: then that is the anchor or, without one, the row
     *                above
     */
    public record Reference(int anchor, double elo, int against) {

        /** The mean, and the row above. */
        public static final Reference NONE = new Reference(-1, 0, -1);

        /** Returns the one version to which differences are told, or -1 if it is the row above. */
        public int compared() {
            return against >= 0 ? against : anchor;
        }

        private Reference among(Set<Integer> versions) {
            return new Reference(versions.contains(anchor) ? anchor : -1, elo,
                versions.contains(against) ? against : -1);
        }
    }

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

        /** True of the versions among these that draw by lot. */
        public static IntPredicate random(List<Entry> entries) {
            return version -> entries.stream().anyMatch(entry -> entry.random() && entry.version() == version);
        }
    }

    /**
     * A row.
     *
     * @param rank   from 1; equal ratings share one
     * @param best   the best rank that the games leave it, with 95%
     * @param component number of the bots that can be compared with it, from 1
     * @param rating in Elo; NaN if it can be compared with no other bot
     * @param bar    half the width of its 95% bar at a number of games that was fixed before
     * @param bound  where the bar has one side, since the bot has won or lost nearly everything: its end; otherwise NaN
     * @param anytime half the width of its 95% bar that holds at all looks at once
     * @param to     version to which the difference is told, or -1
     * @param difference to that version
     * @param points share of the points, 0..1; NaN without games
     * @param wins   games won, in whole games of two
     * @param draws  games drawn, likewise
     * @param losses games lost, likewise
     * @param sums   games, score, faults, answer times
     */
    public record Row(int rank, int best, int worst, Entry entry, int component, double rating, double bar,
                      double bound, double anytime, int to, Difference difference, double points,
                      double wins, double draws, double losses, BotSums sums) {

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
        return of(results, entries, Reference.NONE);
    }

    /** Rates them against a reference; a version of it that has no row is none. */
    public static LeagueTable of(Results results, List<Entry> entries, Reference wanted) {
        Map<Integer, Entry> shown = new HashMap<>();
        shown(results, entries).forEach(entry -> shown.put(entry.version(), entry));
        Reference reference = wanted.among(shown.keySet());
        Ratings ratings = Ratings.of(results, List.copyOf(shown.keySet()));
        List<RankRange> ranks = ratings.ranks();
        Map<Integer, double[]> met = results.sumsOver(ratings.versions());
        List<Row> rows = new ArrayList<>();
        int component = 0;
        for (List<Integer> comparable : ratings.components()) {
            component++;
            for (int version : comparable) {
                boolean anchored = comparable.size() > 1 && comparable.contains(reference.anchor());
                double zero = anchored ? reference.elo() : 0;
                Difference rating = ratings.anchored(version, reference.anchor());
                Row above = rows.isEmpty() ? null : rows.get(rows.size() - 1);
                int rank = above != null && above.component() == component && above.rating() == zero + rating.elo()
                    ? above.rank() : rows.size() + 1;
                int to = reference.compared() >= 0 ? reference.compared() : above == null ? -1
                    : above.entry().version();
                double[] points = met.get(version);
                RankRange range = ranks.get(ratings.versions().indexOf(version));
                rows.add(new Row(rank, range.best(), range.worst(), shown.get(version), component,
                    zero + rating.elo(), rating.bar(), zero + rating.boundElo(), rating.anytimeBar(),
                    to == version ? -1 : to, to == version || to < 0 ? Difference.NONE : ratings.bounded(version, to),
                    points[0] / points[1], points[2], points[3], points[1] - points[2] - points[3],
                    results.of(version)));
            }
        }
        return new LeagueTable(rows, results, ratings, reference);
    }

    /** Returns the entries that have a row: those that play or have games. */
    public static List<Entry> shown(Results results, List<Entry> entries) {
        return entries.stream().filter(entry -> entry.active() || results.of(entry.version()).games() > 0).toList();
    }

    /** Returns the name of a version that has a row. */
    public String name(int version) {
        return rows.stream().map(Row::entry).filter(entry -> entry.version() == version).findFirst().orElseThrow()
            .name();
    }

    /**
     * A bound between two components.
     *
     * @param upper rows of the bots that took every point
     * @param lower rows of those that took none from them
     * @param seeds in which they did
     * @param difference of the last of the upper and the first of the lower ones
     */
    public record Apart(List<Row> upper, List<Row> lower, long seeds, Difference difference) { }

    /** Returns by component, but for the first, how far it is behind the nearest one that took every point from it. */
    public List<Apart> apart() {
        Map<Integer, List<Row>> components = rows.stream().collect(Collectors.groupingBy(Row::component));
        List<Apart> apart = new ArrayList<>();
        for (int lower = 2; lower <= components.size(); lower++) {
            Row first = components.get(lower).get(0);
            for (int upper = lower - 1; upper > 0; upper--) {
                List<Row> above = components.get(upper);
                Row last = above.get(above.size() - 1);
                long seeds = ratings.sweptSeeds(last.entry().version(), first.entry().version());
                if (seeds > 0) {
                    apart.add(new Apart(above, components.get(lower), seeds,
                        ratings.bounded(last.entry().version(), first.entry().version())));
                    break;
                }
            }
        }
        return apart;
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

    /** Likelihood of superiority of the bot of a row; NaN where nothing is known. */
    public double superiority(int row, int column) {
        return ratings.superiority(rows.get(row).entry().version(), rows.get(column).entry().version());
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
