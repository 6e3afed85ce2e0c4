package steward.league.promise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * A group of made-up bots: the ways in which a cluster of theirs can go, each with its exact chance. Games of one seed
 * go together by a push that they share: up or down by the same amount, with equal chances.
 *
 * @param chances  of each way
 * @param patterns of each way, as {@link Stratum} has them, in ascending order
 */
record MadeUpGroup(double weight, int[][] groups, int[] bots, double[] chances, List<double[]> patterns) {

    private static Map<double[], Double> ways() {
        return new TreeMap<>(Arrays::compare);
    }

    /** @param games chances of the numbers of each game, by what the seed is worth to each bot, in natural units */
    private static MadeUpGroup of(double weight, double push, int[][] groups,
                                  Function<double[], List<Map<double[], Double>>> games) {
        int[] bots = Stream.of(groups).flatMapToInt(Arrays::stream).sorted().distinct().toArray();
        int numbers = Stream.of(groups).mapToInt(group -> 3 * group.length * (group.length - 1) / 2).sum();
        Map<double[], Double> chances = ways();
        int pushes = push == 0 ? 1 : 1 << bots.length - 1;
        for (int which = 0; which < pushes; which++) {
            double[] shifts = new double[bots[bots.length - 1] + 1];
            for (int k = 1; k < bots.length; k++) {
                shifts[bots[k]] = (which >> k - 1 & 1) == 0 ? push : -push;
            }
            Map<double[], Double> sums = Map.of(new double[numbers], 1.0 / pushes);
            for (Map<double[], Double> game : games.apply(shifts)) {
                sums = sums(sums, game);
            }
            sums.forEach((pattern, chance) -> chances.merge(pattern, chance, Double::sum));
        }
        return new MadeUpGroup(weight, groups, bots,
            chances.values().stream().mapToDouble(Double::doubleValue).toArray(), new ArrayList<>(chances.keySet()));
    }

    private static Map<double[], Double> sums(Map<double[], Double> before, Map<double[], Double> game) {
        Map<double[], Double> sums = ways();
        before.forEach((numbers, chance) -> game.forEach((more, also) -> {
            double[] sum = numbers.clone();
            Arrays.setAll(sum, k -> numbers[k] + more[k]);
            sums.merge(sum, chance * also, Double::sum);
        }));
        return sums;
    }

    /** An empty stratum with a pattern for each way. */
    Stratum stratum() {
        Stratum stratum = new Stratum(weight, groups);
        patterns.forEach(stratum::pattern);
        return stratum;
    }

    /** A stratum in which every way has come as often as is to be expected, so often that no prior matters. */
    Stratum truth() {
        Stratum stratum = stratum();
        for (int way = 0; way < chances.length; way++) {
            stratum.add(way, Math.round(chances[way] * 0x1p40));
        }
        return stratum;
    }

    /** Draws a cluster: the number of its pattern. */
    int draw(SplitMix64 random) {
        double left = (random.nextLong() >>> 11) * 0x1p-53;
        int way = 0;
        while (way < chances.length - 1 && left >= chances[way]) {
            left -= chances[way++];
        }
        return way;
    }

    /** Mean score of the first of two bots in each way. */
    double[] scores() {
        return patterns.stream().mapToDouble(pattern -> pattern[1] / pattern[0]).toArray();
    }

    /**
     * Pairs of bots, all on one list of seeds; a seed is worth to a bot as much in all its games. The expected points
     * of a game are p = 1/(1 + exp(-apart)), whatever share of the games is drawn.
     *
     * @param apart of each pair the difference; as side and push in natural units
     * @param drawn share of the games drawn if both are even; of others 2 min(p, 1 - p) times as many
     * @param side  advantage of the first side
     */
    static MadeUpGroup pairs(double[] apart, double drawn, double side, double push, int[]... pairs) {
        return of(1, push, pairs, shifts -> IntStream.range(0, 2 * pairs.length).mapToObj(game -> {
            int pair = game / 2;
            double points = 1 / (1 + StrictMath.exp(-apart[pair] + (game % 2 == 0 ? -side : side)
                - shifts[pairs[pair][0]] + shifts[pairs[pair][1]]));
            double tie = drawn * 2 * Math.min(points, 1 - points);
            double[] chances = {1 - points - tie / 2, tie, points - tie / 2};
            Map<double[], Double> results = ways();
            for (int result = 0; result < chances.length; result++) {
                double[] numbers = new double[3 * pairs.length];
                numbers[3 * pair] = 1;
                numbers[3 * pair + 1] = result / 2.0;
                numbers[3 * pair + 2] = result % 2;
                results.put(numbers, chances[result]);
            }
            results.values().removeIf(chance -> chance == 0);
            return results;
        }).toList());
    }

    /**
     * Any number of bots whose places are drawn one after the other, each with the odds of its strength among those
     * that are left (R. L. Plackett, "The analysis of permutations", Applied Statistics 24, 1975).
     *
     * @param alone whether they play alone, on one map
     */
    static MadeUpGroup many(double[] strengths, boolean alone, double push, int... bots) {
        double weight = alone ? 1 : 2.0 / bots.length;
        return of(weight, push, new int[][] {bots}, shifts -> {
            double[] odds = new double[bots.length];
            Arrays.setAll(odds, k -> StrictMath.exp(strengths[k] + shifts[bots[k]]));
            Map<double[], Double> orders = ways();
            addOrders(orders, weight, odds, 1);
            return Collections.nCopies(alone ? 1 : bots.length, orders);
        });
    }

    /** Adds the orders that begin with these bots, as the numbers of a game. */
    private static void addOrders(Map<double[], Double> orders, double weight, double[] odds, double chance,
                                  Integer... first) {
        List<Integer> placed = List.of(first);
        List<Integer> left = IntStream.range(0, odds.length).boxed().filter(bot -> !placed.contains(bot)).toList();
        double all = left.stream().mapToDouble(bot -> odds[bot]).sum();
        for (Integer next : left) {
            Integer[] longer = Arrays.copyOf(first, first.length + 1);
            longer[first.length] = next;
            addOrders(orders, weight, odds, chance * odds[next] / all, longer);
        }
        if (left.isEmpty()) {
            orders.put(IntStream.range(0, odds.length).boxed().flatMap(i -> IntStream.range(i + 1, odds.length)
                .mapToObj(j -> placed.indexOf(i) < placed.indexOf(j))).flatMapToDouble(isAhead ->
                    DoubleStream.of(weight, isAhead ? weight : 0, 0)).toArray(), chance);
        }
    }
}
