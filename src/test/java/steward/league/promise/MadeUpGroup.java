package steward.league.promise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
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

    /** The chances of the ways in which a game can go. */
    interface Game {
        /** @param shifts of the seed, one for each bot, in natural units */
        Map<double[], Double> outcomes(int seat, double... shifts);
    }

    private static Map<double[], Double> map() {
        return new TreeMap<>(Arrays::compare);
    }

    private static int[] bots(int[]... groups) {
        return Stream.of(groups).flatMapToInt(Arrays::stream).sorted().distinct().toArray();
    }

    private static MadeUpGroup of(double weight, Game game, int games, double push, int[]... groups) {
        int[] bots = bots(groups);
        int numbers = Stream.of(groups).mapToInt(group -> 3 * group.length * (group.length - 1) / 2).sum();
        Map<double[], Double> chances = map();
        int pushes = push == 0 ? 1 : 1 << bots.length - 1;
        for (int which = 0; which < pushes; which++) {
            double[] shifts = new double[bots.length];
            for (int k = 1; k < bots.length; k++) {
                shifts[k] = (which >> k - 1 & 1) == 0 ? push : -push;
            }
            Map<double[], Double> sums = map();
            sums.put(new double[numbers], 1.0 / pushes);
            for (int seat = 0; seat < games; seat++) {
                Map<double[], Double> longer = map();
                Map<double[], Double> outcomes = game.outcomes(seat, shifts);
                sums.forEach((before, chance) -> outcomes.forEach((outcome, also) -> {
                    double[] sum = before.clone();
                    Arrays.setAll(sum, k -> before[k] + outcome[k]);
                    longer.merge(sum, chance * also, Double::sum);
                }));
                sums = longer;
            }
            sums.forEach((pattern, chance) -> chances.merge(pattern, chance, Double::sum));
        }
        return new MadeUpGroup(weight, groups, bots,
            chances.values().stream().mapToDouble(Double::doubleValue).toArray(), new ArrayList<>(chances.keySet()));
    }

    /** An empty stratum with a pattern for each way. */
    Stratum stratum() {
        Stratum stratum = new Stratum(weight, groups);
        patterns.forEach(stratum::pattern);
        return stratum;
    }

    /** A stratum in which everything has gone as is to be expected, so many times. */
    Stratum truth(long clusters) {
        double[] expected = new double[patterns.get(0).length];
        for (int way = 0; way < chances.length; way++) {
            for (int k = 0; k < expected.length; k++) {
                expected[k] += chances[way] * patterns.get(way)[k];
            }
        }
        Stratum stratum = new Stratum(weight, groups);
        stratum.add(stratum.pattern(expected), clusters);
        return stratum;
    }

    /** A stratum in which every way has come as often as is to be expected. */
    Stratum inProportion(long clusters) {
        Stratum stratum = stratum();
        for (int way = 0; way < chances.length; way++) {
            stratum.add(way, Math.round(chances[way] * clusters));
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

    /** Mean and variance of {@link #scores}. */
    double[] moments() {
        double[] scores = scores();
        double[] moments = new double[2];
        for (int way = 0; way < scores.length; way++) {
            moments[0] += chances[way] * scores[way];
        }
        for (int way = 0; way < scores.length; way++) {
            moments[1] += chances[way] * (scores[way] - moments[0]) * (scores[way] - moments[0]);
        }
        return moments;
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
        int[] bots = bots(pairs);
        return of(1, (seat, shifts) -> {
            Map<double[], Double> outcomes = map();
            outcomes.put(new double[0], 1.0);
            for (int pair = 0; pair < pairs.length; pair++) {
                double points = 1 / (1 + StrictMath.exp(-apart[pair] + (seat == 0 ? -side : side)
                    - shifts[Arrays.binarySearch(bots, pairs[pair][0])]
                    + shifts[Arrays.binarySearch(bots, pairs[pair][1])]));
                double tie = drawn * 2 * Math.min(points, 1 - points);
                double[] chances = {1 - points - tie / 2, tie, points - tie / 2};
                Map<double[], Double> longer = map();
                outcomes.forEach((before, chance) -> {
                    for (int result = 0; result < chances.length; result++) {
                        double[] more = Arrays.copyOf(before, before.length + 3);
                        more[before.length] = 1;
                        more[before.length + 1] = result / 2.0;
                        more[before.length + 2] = result % 2;
                        longer.put(more, chance * chances[result]);
                    }
                });
                longer.values().removeIf(chance -> chance == 0);
                outcomes = longer;
            }
            return outcomes;
        }, 2, push, pairs);
    }

    /**
     * Any number of bots whose places are drawn one after the other, each with the odds of its strength among those
     * that are left (R. L. Plackett, "The analysis of permutations", Applied Statistics 24, 1975).
     *
     * @param alone whether they play alone, on one map
     */
    static MadeUpGroup many(double[] strengths, boolean alone, double push, int... bots) {
        double weight = alone ? 1 : 2.0 / bots.length;
        return of(weight, (seat, shifts) -> {
            Map<double[], Double> outcomes = map();
            double[] odds = new double[bots.length];
            Arrays.setAll(odds, k -> StrictMath.exp(strengths[k] + shifts[k]));
            int[] places = new int[bots.length];
            Arrays.fill(places, bots.length);
            place(odds, places, 0, 1, weight, outcomes);
            return outcomes;
        }, alone ? 1 : bots.length, push, bots);
    }

    private static void place(double[] odds, int[] places, int next, double chance, double weight,
                              Map<double[], Double> outcomes) {
        int players = odds.length;
        if (next == players) {
            double[] numbers = new double[3 * players * (players - 1) / 2];
            for (int i = 0, at = 0; i < players; i++) {
                for (int j = i + 1; j < players; j++, at += 3) {
                    numbers[at] = weight;
                    numbers[at + 1] = places[i] < places[j] ? weight : 0;
                }
            }
            outcomes.merge(numbers, chance, Double::sum);
            return;
        }
        double all = 0;
        for (int k = 0; k < players; k++) {
            all += places[k] == players ? odds[k] : 0;
        }
        for (int k = 0; k < players; k++) {
            if (places[k] == players) {
                places[k] = next;
                place(odds, places, next + 1, chance * odds[k] / all, weight, outcomes);
                places[k] = players;
            }
        }
    }
}
