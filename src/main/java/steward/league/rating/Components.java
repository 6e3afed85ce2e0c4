package steward.league.rating;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Groups of bots whose ratings can be compared: the strongly connected components of the relation "took points from".
 * Within a component the equations of {@link RatingFit} have exactly one solution. Two components have never met, or
 * one took every point from the other; then any difference beyond some bound fits the games (L. R. Ford, "Solution of a
 * ranking problem from binary comparisons", American Mathematical Monthly 64, 1957).
 */
public final class Components {

    private static final double ROUNDING = 1e-9;

    /** By bot, the number of its component; the upper ones first. */
    private final int[] numbers;
    private final List<int[]> members;

    private Components(int[] numbers, List<int[]> members) {
        this.numbers = numbers;
        this.members = members;
    }

    static Components of(int bots, List<Stratum> strata) {
        BitSet[] reached = new BitSet[bots];
        Arrays.setAll(reached, bot -> new BitSet(bots));
        double[] points = new double[bots];
        double[] games = new double[bots];
        IntStream.range(0, bots).forEach(bot -> reached[bot].set(bot));
        Stratum.each(strata, (q, k, low, high) -> {
            double[] sums = strata.get(q).sums;
            double all = sums[3 * k];
            double own = sums[3 * k + 1];
            reached[low].set(high, reached[low].get(high) || own > ROUNDING * all);
            reached[high].set(low, reached[high].get(low) || all - own > ROUNDING * all);
            points[low] += own;
            points[high] += all - own;
            games[low] += all;
            games[high] += all;
        });
        for (int through = 0; through < bots; through++) {
            for (int from = 0; from < bots; from++) {
                if (reached[from].get(through)) {
                    reached[from].or(reached[through]);
                }
            }
        }
        Map<BitSet, List<Integer>> found = new HashMap<>();
        IntStream.range(0, bots).forEach(bot -> found.computeIfAbsent(reached[bot], key -> new ArrayList<>()).add(bot));
        // A component above another reaches all that the other reaches, and more.
        List<int[]> members = found.values().stream()
            .map(all -> all.stream().mapToInt(Integer::intValue).toArray())
            .sorted(Comparator.comparingInt((int[] all) -> -reached[all[0]].cardinality())
                .thenComparingDouble(all -> -share(all, points, games)).thenComparingInt(all -> all[0])).toList();
        int[] numbers = new int[bots];
        for (int number = 0; number < members.size(); number++) {
            for (int bot : members.get(number)) {
                numbers[bot] = number;
            }
        }
        return new Components(numbers, members);
    }

    private static double share(int[] bots, double[] points, double... games) {
        return IntStream.of(bots).mapToDouble(bot -> points[bot]).sum()
            / Math.max(1, IntStream.of(bots).mapToDouble(bot -> games[bot]).sum());
    }

    /** Returns how many components there are. */
    public int count() {
        return members.size();
    }

    /** Returns the number of a bot's component. A component took points of those with a higher number only. */
    public int of(int bot) {
        return numbers[bot];
    }

    /** Returns the bots of a component, ascending. */
    public int[] members(int number) {
        return members.get(number).clone();
    }

    /** True if the ratings of two bots can be compared. */
    public boolean together(int one, int other) {
        return numbers[one] == numbers[other];
    }

    /** True if a bot can be compared with no other. */
    public boolean isAlone(int bot) {
        return members.get(numbers[bot]).length == 1;
    }
}
