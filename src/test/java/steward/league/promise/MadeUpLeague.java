package steward.league.promise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.league.RoundOrder;
import steward.league.rating.RatingFit;

/**
 * Bots of known strength, and the chances of the results of their games.
 *
 * @param hero   the bot that is in all groups, where all play against one; otherwise -1
 * @param groups all that can be paired
 * @param pairs  all pairs of bots, whether they can meet or not
 * @param truth  the fit under uniform pairing of the groups without chance
 */
record MadeUpLeague(String name, int hero, List<MadeUpGroup> groups, List<int[]> pairs, RatingFit truth) {

    static final MadeUpLeague TRIO = pairs("3 bots, rock, paper, scissors of 150 Elo", spaced(3, 0), 0.05, 0, 0, 150);
    static final MadeUpLeague MIXED = pairs("6 bots, three of them in a circle, draws, seeds, sides", spaced(6, 40),
        0.15, 30, 60, 100);
    static final MadeUpLeague LARGE = pairs("30 bots, draws, seeds of 60 Elo", spaced(30, 20), 0.05, 0, 60, 0);
    static final MadeUpLeague THREES = many("5 bots, 3 players", 5, 3, 0);
    static final List<MadeUpLeague> KINDS = List.of(TRIO, MIXED, THREES);

    private static MadeUpLeague of(String name, int bots, int hero, Stream<MadeUpGroup> all) {
        List<MadeUpGroup> groups = all.toList();
        return new MadeUpLeague(name, hero, groups, groups(bots, 2), RatingFit.of(bots,
            groups.stream().map(group -> group.stratum(0x1p40)).toList(), groups.get(0).weight() == 1));
    }

    /** Returns these bots with some of the groups; its truth is the fit to such games, not to all pairings. */
    private MadeUpLeague only(String words, int against, Predicate<int[]> meet) {
        return of(name + words, truth.bots(), against, groups.stream().filter(group -> meet.test(group.bots())));
    }

    MadeUpLeague gauntlet(int bot) {
        return only(", all against bot " + (bot + 1), bot, group -> Arrays.binarySearch(group, bot) >= 0);
    }

    double truth(int... pair) {
        return truth.rating(pair[0]) - truth.rating(pair[1]);
    }

    /** Returns the least and the most number of pairs with an expected score of 5 to 95%, and the least of others. */
    double[] range(int from, double... numbers) {
        DoubleSummaryStatistics usual = new DoubleSummaryStatistics();
        DoubleSummaryStatistics others = new DoubleSummaryStatistics();
        for (int k = 0; k < pairs.size(); k++) {
            double score = truth.expected(pairs.get(k)[0], pairs.get(k)[1]);
            if (!Double.isNaN(score)) {
                (score < 0.05 || score > 0.95 ? others : usual).accept(numbers[from + k]);
            }
        }
        return new double[] {usual.getMin(), usual.getMax(), others.getMin()};
    }

    static List<int[]> groups(int bots, int players) {
        return RoundOrder.groups(IntStream.range(0, bots).boxed().toList(), players, -1).stream()
            .sorted(Arrays::compare).toList();
    }

    /**
     * Games of two, as {@link MadeUpGroup#pairs} has them.
     *
     * @param circle by how much bot 0 is better than its strength against bot 1, 1 against 2, and 2 against 0, in Elo
     */
    static MadeUpLeague pairs(String name, double[] elo, double drawn, double side, double push, double circle) {
        return of(name, elo.length, -1, groups(elo.length, 2).stream().map(pair -> {
            double turn = pair[1] > 2 ? 0 : pair[1] - pair[0] == 1 ? circle : -circle;
            return MadeUpGroup.pairs(drawn, side, push, new int[][] {pair}, elo[pair[0]] - elo[pair[1]] + turn);
        }));
    }

    /** Two bots without ties, so many Elo apart. */
    static MadeUpLeague two(double elo) {
        return pairs("2 bots, " + Math.round(elo) + " Elo apart", new double[] {elo, 0}, 0, 0, 0, 0);
    }

    private static MadeUpLeague many(String name, int bots, int players, double push) {
        return of(name, bots, -1, groups(bots, players).stream().map(group ->
            MadeUpGroup.many(spaced(bots, 60), push, group)));
    }

    /** Strengths at equal distances, the strongest first. */
    private static double[] spaced(int bots, double step) {
        return IntStream.range(0, bots).mapToDouble(k -> -step * k).toArray();
    }

    /** Leagues of up to six bots. */
    static List<MadeUpLeague> small() {
        double[] near = {60, 0};
        List<MadeUpLeague> all = new ArrayList<>(List.of(two(0), two(480), two(1200),
            pairs("2 bots, draws", near, 0.3, 0, 0, 0),
            pairs("2 bots, draws, seeds of 150 Elo", near, 0.2, 50, 150, 0),
            pairs("2 bots, draws, sides of 300 Elo", near, 0.2, 300, 0, 0), TRIO, MIXED,
            many("5 bots, 3 players, seeds of 60 Elo", 5, 3, 60), many("4 bots, each alone", 4, 4, 0),
            of("4 bots, all on one list of seeds, seeds of 150 Elo", 4, -1, Stream.of(MadeUpGroup.pairs(0, 0, 150,
                groups(4, 2).toArray(int[][]::new), 60, 120, 180, 60, 120, 60)))));
        for (int percent : new int[] {0, 20, 40, 60, 90}) {
            all.add(pairs("4 bots, " + percent + "% drawn", spaced(4, 60), percent / 100.0, 0, 0, 0));
        }
        all.add(pairs("3 bots, one 800 behind", new double[] {70, 0, -800}, 0.2, 0, 0, 0));
        all.add(pairs("4 bots", spaced(4, 60), 0.2, 0, 0, 0)
            .only(", two pairs that never meet", -1, pair -> pair[0] / 2 == pair[1] / 2));
        return all;
    }

    /** Leagues in which one wins nearly everything, and others whose steps are mixed, and equal. */
    static List<MadeUpLeague> ordered() {
        double[] ahead = {1500, 100, 0, -100, -200};
        double[] mixed = {575, 565, 505, 485, 435, 405, 365, 350, 295, 270, 225, 190, 130, 110, 60, 30};
        return List.of(two(1500), pairs("5 bots, one 1400 Elo ahead", ahead, 0.05, 0, 0, 0),
            pairs("16 bots, 10 to 60 Elo between neighbours", mixed, 0.15, 20, 50, 0),
            pairs("16 bots, 35 Elo between neighbours", spaced(16, 35), 0.15, 20, 50, 0));
    }
}
