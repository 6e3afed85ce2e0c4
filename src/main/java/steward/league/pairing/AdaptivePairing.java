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
 * Chooses the group whose next games shrink most the doubt about the order. The doubt about two bots that are neither
 * surely ordered nor surely equal is the variance of the difference of their ratings. It is a sum over groups, each
 * part being inverse to the group's number of clusters: one more of n takes the part 1/(n + 1) of the group's part
 * away. Sums of these over all doubtful pairs, each as a share of its variance, are compared.
 *
 * <p>All pairs of bots that are in doubt count, not only those that stand beside each other now: which of them do is
 * chance, and where chance says who plays, those who were lucky play less and stay lucky, and bars hold too rarely. For
 * the same reason variances are those of the model, not of the few clusters that a pairing has, and pairs that are
 * settled go on counting: together the part {@link #SETTLED} of those that are not.
 *
 * <p>Before that every pair meets {@value #FIRST} times, and each group of at most {@value #FEW} plays once; always
 * each bot has at least the share {@link #LEAST} of the games that it would have in a round robin. What is chosen
 * follows from results of decisions that are {@code lag} back, at the last of {@link Looks}, and from how often each
 * group was decided on.
 */
public final class AdaptivePairing implements Pairing {

    /** How often every pair meets at first. */
    public static final int FIRST = 4;
    /** Of the games of a round robin. */
    static final double LEAST = 0.2;
    /** Weight of all settled pairs together, against those that are not. */
    static final double SETTLED = 0.5;
    /** If there are no more groups than this, each plays once before doubt decides: what never played has no weight. */
    static final int FEW = 1000;

    private final List<Integer> versions;
    private final IntFunction<Ratings> ratings;
    private final StopRule rule;
    private final int lag;
    private final List<int[]> groups;
    private final Map<List<Integer>, Integer> places = new HashMap<>();
    /** Of each group, how often it was decided on. */
    private final int[] counts;
    /** Of each group, what the doubt would lose by n games of n clusters: to be divided by the number and one more. */
    private double[] worth;
    private final int[] ofBot;
    private final int[] ofPair;
    private long all;
    private int look = -1;
    /** Whether the worth is that of an earlier look: it is computed only when a choice depends on it. */
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
     * The group with the pairs that have met least, of several the one whose bots have played least, while there is a
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

    /** The least played group of a bot that has too few games, or -1. */
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

    /** The first of those groups that were decided on least often, or -1 if there are none. */
    private int least(IntPredicate wanted) {
        int place = -1;
        for (int k = 0; k < counts.length; k++) {
            place = (place < 0 || counts[k] < counts[place]) && wanted.test(k) ? k : place;
        }
        return place;
    }
}
