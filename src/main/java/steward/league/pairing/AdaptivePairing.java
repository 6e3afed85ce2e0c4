package steward.league.pairing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import steward.league.Pairing;
import steward.league.RoundOrder;
import steward.league.rating.Ratings;

/**
 * Pairing that chooses the group of bots whose next games most reduce the doubt about the order of the table. A pair is
 * in doubt while the rule neither orders it nor calls it equal; its doubt is the variance of the difference of its two
 * ratings. That variance is a sum over groups, each term inverse to the group's number of clusters: one cluster more
 * than n reduces the group's term by the share 1/(n + 1). Such reductions, each as a share of its pair's variance, are
 * added up over all doubtful pairs, and the group with the largest sum is chosen.
 *
 * <p>Every undecided pair counts, not only neighbours in the table. Who is a neighbour depends on luck; if luck decided
 * who plays, a lucky bot would play less and keep its luck, and the bars would cover too rarely. For the same reason
 * variances are the model's, not those of the few clusters of a pairing, and settled pairs keep counting: together they
 * have the weight {@link #SETTLED} of the undecided ones.
 *
 * <p>Doubt decides only after every pair has met {@value #FIRST} times and, if there are at most {@value #FEW} groups,
 * each group has played once. Every bot always gets at least the share {@link #LEAST} of its games in a round robin. A
 * choice depends on the results of decisions {@code lag} back, at the last of {@link Looks}, and on how often each
 * group was decided on.
 */
public final class AdaptivePairing implements Pairing {

    /** Meetings of every pair before doubt decides. */
    public static final int FIRST = 4;
    /** Least share of its games in a round robin that every bot gets. */
    static final double LEAST = 0.2;
    /** Weight of all settled pairs together, against those that are not. */
    static final double SETTLED = 0.5;
    /** Most groups that each play once before doubt decides: a group that never played has no weight. */
    static final int FEW = 1000;

    private final List<Integer> versions;
    private final IntFunction<Ratings> ratings;
    private final StopRule rule;
    private final int lag;
    private final List<int[]> groups;
    private final Map<List<Integer>, Integer> places = new HashMap<>();
    /** Decisions on each group. */
    private final int[] counts;
    /** Worth of each group: divided by n (n + 1), n its decisions, it is the reduction of doubt by one more. */
    private double[] worth;
    private final int[] ofBot;
    private final int[] ofPair;
    private long all;
    private int look = -1;
    /** True if the worth is that of an earlier look: it is computed only when a choice depends on it. */
    private boolean due;

    /**
     * @param versions that play
     * @param ratings  of them by the results of decisions below a number, which is never less than before
     * @param rule     says which bots are in doubt
     */
    public AdaptivePairing(List<Integer> versions, int players, int lag, StopRule rule, IntFunction<Ratings> ratings) {
        this.versions = versions.stream().sorted().toList();
        this.ratings = ratings;
        this.rule = rule;
        this.lag = lag;
        groups = RoundOrder.groups(this.versions, players, -1);
        for (int place = 0; place < groups.size(); place++) {
            places.put(key(groups.get(place)), place);
        }
        counts = new int[groups.size()];
        ofBot = new int[this.versions.size()];
        ofPair = new int[ofBot.length * ofBot.length];
    }

    private static List<Integer> key(int... group) {
        return Arrays.stream(group).boxed().toList();
    }

    @Override
    public void made(int times, int... group) {
        Integer place = places.get(key(group));
        if (place == null) {
            return;
        }
        counts[place] += times;
        all += times;
        for (int i = 0; i < group.length; i++) {
            ofBot[index(group[i])] += times;
            for (int j = i + 1; j < group.length; j++) {
                ofPair[index(group[i]) * ofBot.length + index(group[j])] += times;
            }
        }
    }

    private int index(int version) {
        return versions.indexOf(version);
    }

    @Override
    public void next(int decision) {
        int now = Looks.of(decision);
        if (now != look && decision >= lag) {
            look = now;
            due = true;
        }
    }

    /** Returns the worth of a game of each group, or {@code null} if nothing is in doubt. */
    private double[] worth(Ratings found) {
        List<int[]> open = new ArrayList<>();
        List<int[]> settled = new ArrayList<>();
        for (int i = 0; i < versions.size(); i++) {
            for (int j = i + 1; j < versions.size(); j++) {
                boolean doubt = rule.order(found, versions.get(i), versions.get(j)) == StopRule.Order.OPEN;
                (doubt ? open : settled).add(new int[] {versions.get(i), versions.get(j)});
            }
        }
        if (open.isEmpty()) {
            return null;
        }
        double[] worth = new double[groups.size()];
        add(worth, 1, found.parts(open));
        add(worth, SETTLED * open.size() / Math.max(1, settled.size()), found.parts(settled));
        return worth;
    }

    private void add(double[] worth, double weight, Map<List<Integer>, Double> parts) {
        parts.forEach((group, part) -> {
            Integer place = places.get(group);
            if (place != null) {
                worth[place] += weight * part;
            }
        });
    }

    @Override
    public int[] choose(Predicate<int[]> wanted) {
        IntPredicate may = place -> wanted.test(groups.get(place));
        int place = leastMet(may);
        if (place < 0) {
            place = neglected(may);
        }
        int least = least(may);
        if (place < 0 && groups.size() <= FEW && least >= 0 && counts[least] == 0) {
            place = least;
        }
        if (place < 0 && due) {
            due = false;
            worth = worth(ratings.apply(look - lag + 1));
        }
        if (place < 0 && worth != null) {
            double best = 0;
            for (int k = 0; k < worth.length; k++) {
                double gain = worth[k] / ((double) counts[k] * (counts[k] + 1));
                if (gain > best && may.test(k)) {
                    best = gain;
                    place = k;
                }
            }
        }
        place = place < 0 ? least : place;
        return place < 0 ? null : groups.get(place).clone();
    }

    /**
     * Returns the group whose pairs have met least, of several the one whose bots have played least, while there is a
     * pair that has met too rarely; or -1.
     */
    private int leastMet(IntPredicate may) {
        int place = -1;
        long fewest = Long.MAX_VALUE;
        if (all >= (long) FIRST * groups.size()) {
            return -1;
        }
        for (int k = 0; k < groups.size(); k++) {
            int[] group = groups.get(k);
            long met = 0;
            long games = 0;
            boolean rare = false;
            for (int i = 0; i < group.length; i++) {
                games += ofBot[index(group[i])];
                for (int j = i + 1; j < group.length; j++) {
                    int ofTwo = ofPair[index(group[i]) * ofBot.length + index(group[j])];
                    met += ofTwo;
                    rare |= ofTwo < FIRST;
                }
            }
            long order = met << Integer.SIZE | games;
            if (rare && order < fewest && may.test(k)) {
                fewest = order;
                place = k;
            }
        }
        return place;
    }

    /** Returns the least played group of a bot that has too few games, or -1. */
    private int neglected(IntPredicate may) {
        for (int bot = 0; bot < ofBot.length; bot++) {
            double uniform = (double) all * groups.get(0).length / ofBot.length;
            if (ofBot[bot] < LEAST * uniform) {
                int version = versions.get(bot);
                int place = least(k -> Arrays.stream(groups.get(k)).anyMatch(each -> each == version) && may.test(k));
                if (place >= 0) {
                    return place;
                }
            }
        }
        return -1;
    }

    /** Returns the first of the wanted groups with the fewest decisions, or -1 if none is wanted. */
    private int least(IntPredicate wanted) {
        int place = -1;
        for (int k = 0; k < counts.length; k++) {
            place = (place < 0 || counts[k] < counts[place]) && wanted.test(k) ? k : place;
        }
        return place;
    }
}
