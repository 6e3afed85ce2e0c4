package steward.league.rating;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import steward.contest.repeat.Repeats;
import steward.league.Season;
import steward.league.StoredGame;
import steward.numerics.StateHash;

/**
 * Results of a season's games: points between any two versions, and sums for each. Games are added one by one or many
 * at once; the order does not matter. A game of n players counts as its n (n - 1) / 2 pairs, each with the weight 2 /
 * n, so that it has the weight of n - 1 games of two. In a game for one player, the results of two bots on one map
 * count as a game between them. Games of one seed between the same bots are one cluster.
 *
 * <p>Not thread-safe.
 */
public final class Results {

    private final boolean alone;
    private final boolean lowerIsBetter;
    private final Map<Integer, BotSums> sums = new TreeMap<>();
    private final Map<Long, double[]> pairs = new TreeMap<>();
    private final Map<Long, Map<Integer, Double>> maps = new HashMap<>();
    private final Clusters clusters;
    private final Repeats repeats = new Repeats();
    private long games;
    private long again;
    private long without;
    private long forgiven;

    /** None yet of a season's games. */
    public Results(Season season) {
        alone = season.players() == 1;
        clusters = new Clusters(alone);
        lowerIsBetter = season.lowerScoreIsBetter();
    }

    /**
     * Adds a game if it counts. Otherwise it is counted apart.
     *
     * @param random true of versions that draw by lot: equal games of these are independent
     */
    public void add(StoredGame game, IntPredicate random) {
        if (!game.counts()) {
            boolean isForgiven = game.problem() != null && game.problem().startsWith(StoredGame.FORGIVEN);
            addOthers(game.problem() == null ? 1 : 0, game.problem() == null ? 0 : 1, isForgiven ? 1 : 0);
            return;
        }
        if (game.allFailed()) {
            game.seats().forEach(seat -> addAllFailed(seat.version(), 1));
            return;
        }
        game.seats().forEach(seat -> sums(seat.version()).add(seat));
        if (isRepeat(lineup(game.lineup()), IntStream.of(game.lineup()).anyMatch(random) ? 0 : game.transcript())) {
            return;
        }
        if (alone) {
            games++;
            addAlone(game.seed(), game.seats().get(0).version(), game.seats().get(0).score());
        } else {
            addGame(game.seed(), game.lineup(),
                game.seats().stream().mapToInt(StoredGame.StoredSeat::rank).toArray());
        }
    }

    /**
     * True if an equal game was there before: the same versions by seat and the same transcript. It tells nothing, is
     * counted apart, and is not to be added to the points.
     *
     * @param lineup     number of the versions by seat, see {@link #lineup}
     * @param transcript 0 if it is not known, or a bot draws by lot
     */
    public boolean isRepeat(long lineup, long transcript) {
        return repeats.isRepeat(lineup, transcript);
    }

    /** A number for some versions by seat. */
    public static long lineup(int... versions) {
        StateHash hash = new StateHash();
        for (int version : versions) {
            hash.add((long) version);
        }
        return hash.value();
    }

    /** Number of games that were equal to earlier ones, and count for nothing but sums. */
    public long repeats() {
        return repeats.count();
    }

    /** Adds games of a version in which all players failed in the same turn. */
    public void addAllFailed(int version, long count) {
        sums(version).addAllFailed(count);
    }

    /** Adds games that do not count: those that were played again, and those without a result. */
    public void addOthers(long playedAgain, long withoutResult, long forgivenOnes) {
        again += playedAgain;
        without += withoutResult;
        forgiven += forgivenOnes;
    }

    /** Adds a game of a seed; its sums are added apart. */
    public void addGame(long seed, int[] lineup, int... ranks) {
        clusters.add(seed, lineup, ranks);
        addPairs(lineup, ranks, 1);
    }

    /** Adds so many clusters of games that all went so; their sums are added apart. */
    public void addClusters(List<int[]> lineups, List<int[]> ranks, long count) {
        int[] group = Clusters.group(lineups.get(0));
        List<int[]> games = new ArrayList<>();
        for (int k = 0; k < lineups.size(); k++) {
            games.add(Clusters.byVersion(group, lineups.get(k), ranks.get(k)));
            addPairs(lineups.get(k), ranks.get(k), count);
        }
        clusters.add(group, games, count);
    }

    private void addPairs(int[] lineup, int[] ranks, long count) {
        games += count;
        double weight = 2.0 / lineup.length;
        for (int i = 0; i < lineup.length; i++) {
            for (int j = 0; j < i; j++) {
                double points = ranks[i] < ranks[j] ? 1 : ranks[i] == ranks[j] ? 0.5 : 0;
                addPair(lineup[i], lineup[j], points, weight * count);
            }
        }
    }

    private void addPair(int one, int other, double points, double weight) {
        int low = Math.min(one, other);
        double[] pair = pairs.computeIfAbsent(key(low, Math.max(one, other)), key -> new double[4]);
        double ofLow = low == one ? points : 1 - points;
        pair[0] += ofLow * weight;
        pair[1] += weight;
        pair[2] += ofLow == 1 ? weight : 0;
        pair[3] += ofLow == 0.5 ? weight : 0;
    }

    private static long key(int low, int high) {
        return (long) low << Integer.SIZE | high;
    }

    /** Adds what a version reached alone on a map; equal scores are a draw. The sums are added apart. */
    public void addAlone(long map, int version, double score) {
        Map<Integer, Double> scores = maps.computeIfAbsent(map, key -> new TreeMap<>());
        scores.forEach((other, theirs) ->
            addPair(version, other, score == theirs ? 0.5 : lowerIsBetter == score < theirs ? 1 : 0, 1));
        addMap(scores, -1);
        scores.put(version, score);
        addMap(scores, 1);
    }

    /** Adds or takes away a map as a cluster: one game of all who have played it. */
    private void addMap(Map<Integer, Double> scores, int count) {
        if (scores.size() < 2) {
            return;
        }
        double[] all = scores.values().stream().mapToDouble(Double::doubleValue).toArray();
        int[] ranks = new int[all.length];
        for (int k = 0; k < all.length; k++) {
            for (double other : all) {
                ranks[k] += lowerIsBetter ? other < all[k] ? 1 : 0 : other > all[k] ? 1 : 0;
            }
        }
        clusters.add(scores.keySet().stream().mapToInt(Integer::intValue).toArray(), List.of(ranks), count);
    }

    /** Returns the number of clusters: games of one seed between the same bots. */
    public long clusters() {
        return clusters.count();
    }

    /** The clusters of these versions, for a fit in which they have the numbers 0, 1, ... */
    List<Stratum> strata(int... versions) {
        Map<Integer, Integer> places = new HashMap<>();
        for (int k = 0; k < versions.length; k++) {
            places.put(versions[k], k);
        }
        return clusters.strata(places);
    }

    /** True if each bot plays alone. */
    boolean alone() {
        return alone;
    }

    /** Adds so many games played alone, told by {@link #addAlone}. */
    public void addAloneGames(long count) {
        games += count;
    }

    public void addSums(int version, long count, double score, long faults, long answers, double nanos, long worst) {
        sums(version).add(count, score, faults, answers, nanos, worst);
    }

    private BotSums sums(int version) {
        return sums.computeIfAbsent(version, key -> new BotSums());
    }

    /** The sums of a version; all 0 if it has no games. */
    public BotSums of(int version) {
        return sums.getOrDefault(version, new BotSums());
    }

    /** Returns how many games count. */
    public long games() {
        return games;
    }

    /** Returns how many were played again since the machine was starved, and do not count. */
    public long playedAgain() {
        return again;
    }

    /** Returns how many have no result. */
    public long withoutResult() {
        return without;
    }

    /** Of those without a result, games that an operator has set aside. */
    public long forgiven() {
        return forgiven;
    }

    /** By version: points, games, wins and draws against the others of these. */
    Map<Integer, double[]> sumsOver(List<Integer> versions) {
        Map<Integer, double[]> sums = new HashMap<>();
        versions.forEach(version -> sums.put(version, new double[4]));
        pairs.forEach((key, pair) -> {
            double[] low = sums.get((int) (key >>> Integer.SIZE));
            double[] high = sums.get((int) (long) key);
            if (low != null && high != null) {
                double[] turned = {pair[1] - pair[0], pair[1], pair[1] - pair[2] - pair[3], pair[3]};
                for (int k = 0; k < pair.length; k++) {
                    low[k] += pair[k];
                    high[k] += turned[k];
                }
            }
        });
        return sums;
    }

    /** Games between two versions, in whole games of two. */
    public double games(int one, int other) {
        return pair(one, other)[1];
    }

    /** Points of the first in games against the second. */
    public double points(int one, int other) {
        double[] pair = pair(one, other);
        return one < other ? pair[0] : pair[1] - pair[0];
    }

    /** Wins of the first in games against the second. */
    public double wins(int one, int other) {
        double[] pair = pair(one, other);
        return one < other ? pair[2] : pair[1] - pair[2] - pair[3];
    }

    /** Draws between two versions. */
    public double draws(int one, int other) {
        return pair(one, other)[3];
    }

    private double[] pair(int one, int other) {
        return pairs.getOrDefault(key(Math.min(one, other), Math.max(one, other)), new double[4]);
    }
}
