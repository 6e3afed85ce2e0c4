package steward.league.promise;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.league.rating.RatingFit;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * A group of made-up bots: the ways in which a cluster of theirs can go, each with its exact chance. Games of one seed
 * go together by a push that they share: up or down by the same amount, with equal chances. Strengths are in Elo.
 *
 * @param patterns of each way, as {@link Stratum} has them, in ascending order
 */
record MadeUpGroup(double weight, int[][] groups, int[] bots, double[][] patterns, double... chances) {

    private static Map<double[], Double> ways() {
        return new TreeMap<>(Arrays::compare);
    }

    /** @param games chances of the numbers of each game, by what the seed is worth to each bot */
    private static MadeUpGroup of(double weight, double push, int[][] groups,
                                  Function<double[], Stream<Map<double[], Double>>> games) {
        int[] bots = Stream.of(groups).flatMapToInt(Arrays::stream).sorted().distinct().toArray();
        Map<double[], Double> chances = ways();
        int pushes = 1 << bots.length - 1;
        for (int which = 0; which < pushes; which++) {
            double[] shifts = new double[bots[bots.length - 1] + 1];
            for (int k = 1; k < bots.length; k++) {
                shifts[bots[k]] = (which >> k - 1 & 1) == 0 ? push : -push;
            }
            games.apply(shifts).reduce(MadeUpGroup::sums).orElseThrow()
                .forEach((pattern, chance) -> chances.merge(pattern, chance / pushes, Double::sum));
        }
        return new MadeUpGroup(weight, groups, bots, chances.keySet().toArray(double[][]::new),
            chances.values().stream().mapToDouble(chance -> chance).toArray());
    }

    private static Map<double[], Double> sums(Map<double[], Double> before, Map<double[], Double> game) {
        Map<double[], Double> sums = ways();
        before.forEach((numbers, chance) -> game.forEach((more, also) -> sums.merge(IntStream.range(0, more.length)
            .mapToDouble(k -> numbers[k] + more[k]).toArray(), chance * also, Double::sum)));
        return sums;
    }

    /** A stratum with a pattern for each way, which has come as often as is to be expected of so many clusters. */
    Stratum stratum(double clusters) {
        Stratum stratum = new Stratum(weight, groups);
        for (int way = 0; way < chances.length; way++) {
            stratum.add(stratum.pattern(patterns[way]), Math.round(chances[way] * clusters));
        }
        return stratum;
    }

    /** Draws a cluster: the number of its pattern. */
    int draw(SplitMix64 random) {
        int way = 0;
        for (double left = (random.nextLong() >>> 11) * 0x1p-53; way < chances.length - 1 && left >= chances[way];) {
            left -= chances[way++];
        }
        return way;
    }

    /**
     * Pairs of bots, all on one list of seeds; a seed is worth to a bot as much in all its games. The expected points
     * of a game are p = 1/(1 + 10^(-apart/400)), whatever share of the games is drawn.
     *
     * @param drawn share of the games drawn if both are even; of others 2 min(p, 1 - p) times as many
     * @param side  advantage of the first side
     * @param push  what a seed gives to a bot or takes from it
     */
    static MadeUpGroup pairs(double drawn, double side, double push, int[][] pairs, double... apart) {
        return of(1, push, pairs, shifts -> IntStream.range(0, 2 * pairs.length).mapToObj(game -> {
            int pair = game / 2;
            double points = expected(apart[pair] + (game % 2 == 0 ? side : -side)
                + shifts[pairs[pair][0]] - shifts[pairs[pair][1]]);
            double tie = drawn * 2 * Math.min(points, 1 - points);
            double[] chances = {1 - points - tie / 2, tie, points - tie / 2};
            Map<double[], Double> results = ways();
            IntStream.range(0, 3).filter(result -> chances[result] > 0).forEach(result -> {
                double[] numbers = new double[3 * pairs.length];
                System.arraycopy(new double[] {1, result / 2.0, result % 2}, 0, numbers, 3 * pair, 3);
                results.put(numbers, chances[result]);
            });
            return results;
        }));
    }

    /** Expected points of a bot that is so much better. */
    static double expected(double apart) {
        return 1 / (1 + StrictMath.exp(-apart / RatingFit.ELO));
    }

    /**
     * Any number of bots whose places are drawn one after the other, each with the odds of its strength among those
     * that are left (R. L. Plackett, "The analysis of permutations", Applied Statistics 24, 1975). All bots together
     * play alone, each on the same map.
     */
    static MadeUpGroup many(double[] strengths, double push, int... bots) {
        boolean alone = bots.length == strengths.length;
        double weight = alone ? 1 : 2.0 / bots.length;
        return of(weight, push, new int[][] {bots}, shifts -> {
            double[] odds = IntStream.of(bots).mapToDouble(bot ->
                StrictMath.exp((strengths[bot] + shifts[bot]) / RatingFit.ELO)).toArray();
            Map<double[], Double> orders = ways();
            addOrders(orders, weight, odds, 1, List.of());
            return Collections.nCopies(alone ? 1 : bots.length, orders).stream();
        });
    }

    /** Adds the orders that begin with these bots, as the numbers of a game. */
    private static void addOrders(Map<double[], Double> orders, double weight, double[] odds, double chance,
                                  List<Integer> placed) {
        int[] left = IntStream.range(0, odds.length).filter(bot -> !placed.contains(bot)).toArray();
        double all = IntStream.of(left).mapToDouble(bot -> odds[bot]).sum();
        for (int next : left) {
            addOrders(orders, weight, odds, chance * odds[next] / all,
                Stream.concat(placed.stream(), Stream.of(next)).toList());
        }
        if (left.length == 0) {
            orders.put(MadeUpLeague.groups(odds.length, 2).stream().flatMapToDouble(pair -> DoubleStream.of(weight,
                placed.indexOf(pair[0]) < placed.indexOf(pair[1]) ? weight : 0, 0)).toArray(), chance);
        }
    }
}
