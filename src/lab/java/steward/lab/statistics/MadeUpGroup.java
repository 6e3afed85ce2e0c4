package steward.lab.statistics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * A group of made-up bots: the ways in which a cluster of theirs can go, each with its exact probability. Games of one
 * seed go together by a push that they share: up or down by the same amount, with equal chances.
 */
final class MadeUpGroup {

    private static final double HALF = 0.5;

    private final double weight;
    private final int[] bots;
    private final int[][] groups;
    private final List<double[]> patterns = new ArrayList<>();
    private final double[] cumulative;
    private final double[] expected;

    /**
     * Tells the chances of the ways in which a game can go.
     *
     * @param seat by how many places the bots have moved up
     * @param push of the seed, one number for each bot, in natural units
     */
    interface Game {
        Map<List<Double>, Double> outcomes(int seat, double... push);
    }

    /**
     * @param games of a cluster
     * @param push  size of the push, in natural units
     */
    MadeUpGroup(double weight, Game game, int games, double push, int... bots) {
        this(weight, game, games, push, new int[][] {bots});
    }

    /** @param groups that share their seeds */
    private MadeUpGroup(double weight, Game game, int games, double push, int[]... groups) {
        this.weight = weight;
        this.groups = groups;
        bots = Stream.of(groups).flatMapToInt(Arrays::stream).sorted().distinct().toArray();
        int numbers = Stream.of(groups).mapToInt(group -> 3 * group.length * (group.length - 1) / 2).sum();
        Map<List<Double>, Double> chances = new TreeMap<>(MadeUpGroup::compare);
        int pushes = push == 0 ? 1 : 1 << bots.length - 1;
        for (int which = 0; which < pushes; which++) {
            double[] shifts = new double[bots.length];
            for (int k = 1; k < bots.length && push != 0; k++) {
                shifts[k] = (which >> k - 1 & 1) == 0 ? push : -push;
            }
            Map<List<Double>, Double> sums = new TreeMap<>(MadeUpGroup::compare);
            sums.put(Arrays.stream(new double[numbers]).boxed().toList(), 1.0 / pushes);
            for (int seat = 0; seat < games; seat++) {
                sums = added(sums, game.outcomes(seat, shifts));
            }
            sums.forEach((key, chance) -> chances.merge(key, chance, Double::sum));
        }
        cumulative = new double[chances.size()];
        expected = new double[numbers];
        double sum = 0;
        for (Map.Entry<List<Double>, Double> each : chances.entrySet()) {
            double[] pattern = each.getKey().stream().mapToDouble(Double::doubleValue).toArray();
            sum += each.getValue();
            cumulative[patterns.size()] = sum;
            patterns.add(pattern);
            for (int k = 0; k < numbers; k++) {
                expected[k] += each.getValue() * pattern[k];
            }
        }
        cumulative[cumulative.length - 1] = 1;
    }

    private static int compare(List<Double> one, List<Double> other) {
        for (int k = 0; k < one.size(); k++) {
            int order = Double.compare(one.get(k), other.get(k));
            if (order != 0) {
                return order;
            }
        }
        return 0;
    }

    private static Map<List<Double>, Double> added(Map<List<Double>, Double> sums, Map<List<Double>, Double> game) {
        Map<List<Double>, Double> all = new TreeMap<>(MadeUpGroup::compare);
        sums.forEach((key, chance) -> game.forEach((outcome, also) -> {
            List<Double> sum = IntStream.range(0, key.size()).mapToObj(k -> key.get(k) + outcome.get(k)).toList();
            all.merge(sum, chance * also, Double::sum);
        }));
        return all;
    }

    /** An empty stratum with a pattern for each way. */
    Stratum stratum() {
        Stratum stratum = new Stratum(weight, groups);
        patterns.forEach(stratum::pattern);
        return stratum;
    }

    /** A stratum in which everything has gone as is to be expected, so many times. */
    Stratum truth(long clusters) {
        Stratum stratum = new Stratum(weight, groups);
        stratum.add(stratum.pattern(expected), clusters);
        return stratum;
    }

    /** A stratum in which everything has gone as often as is to be expected. */
    Stratum inProportion(long clusters) {
        Stratum stratum = stratum();
        double[] chances = chances();
        for (int k = 0; k < chances.length; k++) {
            stratum.add(k, Math.round(chances[k] * clusters));
        }
        return stratum;
    }

    int[] bots() {
        return bots;
    }

    /** Draws a cluster: the number of its pattern. */
    int draw(SplitMix64 random) {
        double drawn = uniform(random);
        int low = 0;
        int high = cumulative.length - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (drawn >= cumulative[middle]) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private static double uniform(SplitMix64 random) {
        return (random.nextLong() >>> 11) * 0x1p-53;
    }

    double[] chances() {
        double[] chances = cumulative.clone();
        for (int k = chances.length - 1; k > 0; k--) {
            chances[k] -= chances[k - 1];
        }
        return chances;
    }

    /** Returns the mean score of each pattern, of two bots. */
    double[] scores() {
        return patterns.stream().mapToDouble(pattern -> pattern[1] / pattern[0]).toArray();
    }

    /** Returns the variance of a cluster's mean score, of two bots. */
    double variance() {
        double mean = share();
        double sum = 0;
        double[] scores = scores();
        double[] chances = chances();
        for (int k = 0; k < scores.length; k++) {
            sum += chances[k] * (scores[k] - mean) * (scores[k] - mean);
        }
        return sum;
    }

    /** Expected share of the points of the first in games against the second. */
    double share() {
        return expected[1] / expected[0];
    }

    /** Two bots, with ties. */
    static MadeUpGroup two(double difference, double ties, double side, double push, int... bots) {
        Game game = (seat, shifts) -> {
            double up = StrictMath.exp((difference + (seat == 0 ? side : -side) - shifts[1]) * HALF);
            double all = up + 1 / up + ties;
            Map<List<Double>, Double> outcomes = new TreeMap<>(MadeUpGroup::compare);
            outcomes.put(List.of(1.0, 1.0, 0.0), up / all);
            outcomes.put(List.of(1.0, 0.0, 0.0), 1 / (up * all));
            if (ties > 0) {
                outcomes.put(List.of(1.0, HALF, 1.0), ties / all);
            }
            return outcomes;
        };
        return new MadeUpGroup(1, game, 2, push, bots);
    }

    /**
     * Pairs of bots that play all on one list of seeds, without ties; what a seed is worth to a bot it has in all of
     * its games.
     *
     * @param strengths of bots 0, 1, ..., in natural units
     */
    static MadeUpGroup sharing(double[] strengths, double push, int[]... pairs) {
        Game game = (seat, shifts) -> {
            Map<List<Double>, Double> outcomes = Map.of(List.of(), 1.0);
            for (int[] pair : pairs) {
                double apart = strengths[pair[0]] + shifts[pair[0]] - strengths[pair[1]] - shifts[pair[1]];
                double chance = 1 / (1 + StrictMath.exp(-apart));
                Map<List<Double>, Double> longer = new TreeMap<>(MadeUpGroup::compare);
                outcomes.forEach((before, all) -> {
                    longer.put(followed(before, 1), all * chance);
                    longer.put(followed(before, 0), all * (1 - chance));
                });
                outcomes = longer;
            }
            return outcomes;
        };
        return new MadeUpGroup(1, game, 2, push, pairs);
    }

    private static List<Double> followed(List<Double> numbers, double points) {
        List<Double> longer = new ArrayList<>(numbers);
        longer.addAll(List.of(1.0, points, 0.0));
        return longer;
    }

    /**
     * Any number of bots whose places are drawn one after the other, each with the odds of its strength among those
     * that are left (R. L. Plackett, "The analysis of permutations", Applied Statistics 24, 1975).
     *
     * @param alone whether they play alone, on one map
     */
    static MadeUpGroup many(double[] strengths, boolean alone, double push, int... bots) {
        int players = bots.length;
        double weight = alone ? 1 : 2.0 / players;
        Game game = (seat, shifts) -> {
            Map<List<Double>, Double> outcomes = new TreeMap<>(MadeUpGroup::compare);
            double[] odds = new double[players];
            Arrays.setAll(odds, k -> StrictMath.exp(strengths[k] + shifts[k]));
            place(odds, new int[players], new boolean[players], 0, 1, weight, outcomes);
            return outcomes;
        };
        return new MadeUpGroup(weight, game, alone ? 1 : players, push, bots);
    }

    private static void place(double[] odds, int[] places, boolean[] placed, int next, double chance, double weight,
                              Map<List<Double>, Double> outcomes) {
        int players = odds.length;
        if (next == players) {
            List<Double> numbers = new ArrayList<>();
            for (int i = 0; i < players; i++) {
                for (int j = i + 1; j < players; j++) {
                    numbers.addAll(List.of(weight, places[i] < places[j] ? weight : 0, 0.0));
                }
            }
            outcomes.merge(numbers, chance, Double::sum);
            return;
        }
        double all = 0;
        for (int k = 0; k < players; k++) {
            all += placed[k] ? 0 : odds[k];
        }
        for (int k = 0; k < players; k++) {
            if (!placed[k]) {
                placed[k] = true;
                places[k] = next;
                place(odds, places, placed, next + 1, chance * odds[k] / all, weight, outcomes);
                placed[k] = false;
            }
        }
    }
}
