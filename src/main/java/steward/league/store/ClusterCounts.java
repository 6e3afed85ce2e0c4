package steward.league.store;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import steward.league.rating.Results;

/**
 * Games grouped by seed and group of bots while they are read from the database. A cluster in which every bot has been
 * on every seat is only counted by its results, so that a million clusters take little memory and time.
 *
 * <p>Not thread-safe.
 */
final class ClusterCounts {

    private static final int TEN = 10;

    private final Map<Integer, int[]> lineups;
    /** By lineup: the number of its group. */
    private final Map<Integer, Integer> groups = new HashMap<>();
    private final Set<Long> shared;
    private final boolean counting;
    private final Map<Cluster, long[]> open = new LinkedHashMap<>();
    private final Map<Pattern, long[]> counts = new LinkedHashMap<>();

    private record Cluster(long seed, int group) { }

    /** Games of one cluster in ascending order. */
    private record Pattern(long... games) {

        @Override
        public boolean equals(Object other) {
            return other instanceof Pattern pattern && Arrays.equals(games, pattern.games);
        }

        @Override
        public int hashCode() {
            return Arrays.hashCode(games);
        }
    }

    /**
     * @param lineups  the versions by seat of each lineup, by its number
     * @param shared   seeds that several groups may have: of these every game is given away by itself
     * @param counting whether to tell how many games each version has, too
     */
    ClusterCounts(Map<Integer, int[]> lineups, Set<Long> shared, boolean counting) {
        this.lineups = lineups;
        this.shared = shared;
        this.counting = counting;
        Map<List<Integer>, Integer> numbers = new HashMap<>();
        lineups.forEach((number, versions) -> groups.put(number,
            numbers.computeIfAbsent(Arrays.stream(versions).sorted().boxed().toList(), group -> numbers.size())));
    }

    /**
     * Adds a game.
     *
     * @param game the number of the lineup in the upper half; in the lower one the ranks by seat, each a decimal digit
     */
    void add(long seed, long game) {
        int lineup = (int) (game >>> Integer.SIZE);
        Cluster cluster = new Cluster(seed, groups.get(lineup));
        long[] before = open.get(cluster);
        long[] games = before == null ? new long[1] : Arrays.copyOf(before, before.length + 1);
        games[games.length - 1] = game;
        if (games.length < lineups.get(lineup).length || shared.contains(seed)) {
            open.put(cluster, games);
            return;
        }
        open.remove(cluster);
        Arrays.sort(games);
        counts.computeIfAbsent(new Pattern(games), key -> new long[1])[0]++;
    }

    /** Gives away all games, and forgets them. */
    void give(Results results) {
        counts.forEach((pattern, count) -> {
            List<int[]> seats = new ArrayList<>();
            List<int[]> ranks = new ArrayList<>();
            for (long game : pattern.games) {
                seats.add(lineups.get((int) (game >>> Integer.SIZE)));
                ranks.add(ranks(game));
                count(results, game, count[0]);
            }
            results.addClusters(seats, ranks, count[0]);
        });
        counts.clear();
        open.forEach((cluster, games) -> {
            for (long game : games) {
                results.addGame(cluster.seed(), lineups.get((int) (game >>> Integer.SIZE)), ranks(game));
                count(results, game, 1);
            }
        });
        open.clear();
    }

    private void count(Results results, long game, long times) {
        if (counting) {
            for (int version : lineups.get((int) (game >>> Integer.SIZE))) {
                results.addSums(version, times, 0, 0, 0, 0, 0);
            }
        }
    }

    private int[] ranks(long game) {
        int[] ranks = new int[lineups.get((int) (game >>> Integer.SIZE)).length];
        int digits = (int) game;
        for (int seat = ranks.length - 1; seat >= 0; seat--) {
            ranks[seat] = digits % TEN;
            digits /= TEN;
        }
        return ranks;
    }
}
