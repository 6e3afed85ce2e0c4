package steward.league.promise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.league.rating.RatingFit;
import steward.league.rating.Stratum;

/**
 * Bots of known strength, and the chances of the results of their games.
 *
 * @param pooled see {@link RatingFit#of}
 * @param groups all that can be paired
 * @param hero   the bot that is in all groups, where all play against one; otherwise -1
 * @param truth  the fit under uniform pairing of the groups without chance
 */
record MadeUpLeague(String name, int bots, boolean pooled, List<MadeUpGroup> groups, int hero, RatingFit truth) {

    static final MadeUpLeague TRIO = pairs("3 bots, rock, paper, scissors of 150 Elo", spaced(3, 0), 0.05, 0, 0, 150);
    static final MadeUpLeague MIXED = pairs("6 bots, three of them in a circle, draws, seeds, sides", spaced(6, 40),
        0.15, 30, 60, 100);
    static final MadeUpLeague LARGE = pairs("30 bots, draws, seeds of 60 Elo", spaced(30, 20), 0.05, 0, 60, 0);
    static final MadeUpLeague THREES = threes("5 bots, 3 players", 0);
    /** Leagues in which one wins nearly everything. */
    static final List<MadeUpLeague> WON = List.of(two(1500), pairs("5 bots, one 1400 Elo ahead",
        new double[] {1500, 100, 0, -100, -200}, 0.05, 0, 0, 0));

    private static MadeUpLeague of(String name, int bots, boolean pooled, List<MadeUpGroup> groups, int hero) {
        return new MadeUpLeague(name, bots, pooled, groups, hero,
            RatingFit.of(bots, groups.stream().map(MadeUpGroup::truth).toList(), pooled));
    }

    /** Returns these bots with some of the groups; its truth is the fit to such games, not to all pairings. */
    private MadeUpLeague only(Predicate<int[]> meet, int hero) {
        return of(name, bots, pooled, groups.stream().filter(group -> meet.test(group.bots())).toList(), hero);
    }

    /** Returns these bots with all of them against one. */
    MadeUpLeague gauntlet(int bot) {
        return only(group -> IntStream.of(group).anyMatch(each -> each == bot), bot);
    }

    /** Returns this league with another truth to compare its estimates with. */
    MadeUpLeague comparedWith(RatingFit other) {
        return new MadeUpLeague(name, bots, pooled, groups, hero, other);
    }

    /** Words for parts of the pairs: true for those with the bot of a gauntlet, false for others, null for all. */
    Map<String, Boolean> parts() {
        Map<String, Boolean> parts = new LinkedHashMap<>();
        if (hero < 0) {
            parts.put("", null);
        } else {
            parts.put(": with it", true);
            parts.put(": others", false);
        }
        return parts;
    }

    List<Stratum> strata() {
        return groups.stream().map(MadeUpGroup::stratum).toList();
    }

    double truth(int i, int j) {
        return truth.rating(i) - truth.rating(j);
    }

    int pairs() {
        return bots * (bots - 1) / 2;
    }

    /**
     * Games of two.
     *
     * @param drawn  share of the games drawn between even bots
     * @param side   advantage of the first side, in Elo
     * @param push   advantage that a seed gives to one of the two, in Elo
     * @param circle by how much bot 0 is better than its strength against bot 1, 1 against 2, and 2 against 0, in Elo
     */
    static MadeUpLeague pairs(String name, double[] elo, double drawn, double side, double push, double circle) {
        List<MadeUpGroup> groups = new ArrayList<>();
        for (int i = 0; i < elo.length; i++) {
            for (int j = i + 1; j < elo.length; j++) {
                double turn = j > 2 ? 0 : j - i == 1 ? circle : -circle;
                groups.add(MadeUpGroup.pairs(natural(elo[i] - elo[j] + turn), drawn, side / RatingFit.ELO,
                    push / RatingFit.ELO, new int[] {i, j}));
            }
        }
        return of(name, elo.length, false, groups, -1);
    }

    /** Two bots without ties, so many Elo apart. */
    static MadeUpLeague two(double elo) {
        return pairs("2 bots, " + Math.round(elo) + " Elo apart", new double[] {elo, 0}, 0, 0, 0, 0);
    }

    private static MadeUpLeague threes(String name, double push) {
        double[] strengths = natural(spaced(5, 60));
        List<MadeUpGroup> groups = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            for (int j = i + 1; j < 5; j++) {
                for (int k = j + 1; k < 5; k++) {
                    groups.add(MadeUpGroup.many(new double[] {strengths[i], strengths[j], strengths[k]}, false,
                        push / RatingFit.ELO, i, j, k));
                }
            }
        }
        return of(name, 5, false, groups, -1);
    }

    private static MadeUpLeague sharing(String name, int bots, int[]... pairs) {
        double[] apart = natural(Stream.of(pairs).mapToDouble(pair -> 60 * (pair[1] - pair[0])).toArray());
        return of(name + ", seeds of 150 Elo", bots, false,
            List.of(MadeUpGroup.pairs(apart, 0, 0, 150 / RatingFit.ELO, pairs)), -1);
    }

    private static double[] natural(double... elo) {
        return Arrays.stream(elo).map(each -> each / RatingFit.ELO).toArray();
    }

    /** Strengths at equal distances, the strongest first. */
    private static double[] spaced(int bots, double step) {
        return IntStream.range(0, bots).mapToDouble(k -> -step * k).toArray();
    }

    /** Leagues of up to six bots. */
    static List<MadeUpLeague> small() {
        List<MadeUpLeague> all = new ArrayList<>();
        for (double elo : new double[] {0, 100, 300, 400, 480, 550, 700, 800, 1200}) {
            all.add(two(elo));
        }
        double[] near = {60, 0};
        all.addAll(List.of(pairs("2 bots, draws", near, 0.3, 0, 0, 0),
            pairs("2 bots, draws, seeds of 150 Elo", near, 0.2, 50, 150, 0),
            pairs("2 bots, draws, sides of 300 Elo", near, 0.2, 300, 0, 0), TRIO, MIXED,
            threes("5 bots, 3 players, seeds of 60 Elo", 60), of("4 bots, each alone", 4, true,
                List.of(MadeUpGroup.many(natural(spaced(4, 60)), true, 0, 0, 1, 2, 3)), -1),
            sharing("5 bots, one against all on one list of seeds", 5, new int[][] {{0, 1}, {0, 2}, {0, 3}, {0, 4}}),
            sharing("4 bots, all on one list of seeds", 4,
                new int[][] {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}})));
        // Expected points follow from Elo: at five shares of draws, one bot far behind, two pairs that never meet.
        for (int percent : new int[] {0, 20, 40, 60, 90}) {
            all.add(pairs("4 bots, " + percent + "% drawn", spaced(4, 60), percent / 100.0, 0, 0, 0));
        }
        all.add(pairs("3 bots, one 800 behind", new double[] {70, 0, -800}, 0.2, 0, 0, 0));
        all.add(pairs("4 bots, two pairs that never meet", spaced(4, 60), 0.2, 0, 0, 0)
            .only(pair -> pair[0] / 2 == pair[1] / 2, -1));
        return all;
    }

    /** 16 bots, by the steps in Elo between neighbours. */
    static MadeUpLeague sixteen(double... steps) {
        double[] elo = new double[steps.length + 1];
        for (int k = 0; k < steps.length; k++) {
            elo[k + 1] = elo[k] - steps[k];
        }
        return pairs("16 bots", elo, 0.15, 20, 50, 0);
    }
}
