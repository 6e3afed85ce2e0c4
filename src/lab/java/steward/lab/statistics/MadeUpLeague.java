package steward.lab.statistics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import steward.league.rating.RatingFit;

/**
 * Simulated league: bots of known strength, and the probabilities of the results of their games.
 *
 * @param name   of the configuration, for a person
 * @param bots   how many
 * @param pooled see {@link RatingFit#of}
 * @param groups all that can be paired
 * @param hero   the bot that is in all groups, where all play against one; otherwise -1
 * @param truth  the fit under uniform pairing of the groups without chance
 */
record MadeUpLeague(String name, int bots, boolean pooled, List<MadeUpGroup> groups, int hero, RatingFit truth) {

    /** Number of clusters so large that the prior does not matter. */
    private static final long MANY = 1L << 40;

    static MadeUpLeague of(String name, int bots, boolean pooled, List<MadeUpGroup> groups) {
        return of(name, bots, pooled, groups, -1);
    }

    private static MadeUpLeague of(String name, int bots, boolean pooled, List<MadeUpGroup> groups, int hero) {
        return new MadeUpLeague(name, bots, pooled, List.copyOf(groups), hero,
            RatingFit.of(bots, groups.stream().map(group -> group.truth(MANY)).toList(), pooled));
    }

    /** Returns these bots with all of them against one; its truth is the fit to such games, not to all pairings. */
    MadeUpLeague gauntlet(int bot) {
        return of(name, bots, pooled,
            groups.stream().filter(group -> IntStream.of(group.bots()).anyMatch(each -> each == bot)).toList(), bot);
    }

    /** Returns this league with another truth to compare its estimates with. */
    MadeUpLeague comparedWith(RatingFit other) {
        return new MadeUpLeague(name, bots, pooled, groups, hero, other);
    }

    /**
     * Returns a league of games of two.
     *
     * @param elo      strengths
     * @param ties     weight of ties
     * @param side     advantage of the first side, in Elo
     * @param push     advantage that a seed gives to one of the two, in Elo
     * @param circle   by how much bot 0 is better than its strength against bot 1, 1 against 2, and 2 against 0, in Elo
     */
    static MadeUpLeague pairs(String name, double[] elo, double ties, double side, double push, double circle) {
        List<MadeUpGroup> groups = new ArrayList<>();
        for (int i = 0; i < elo.length; i++) {
            for (int j = i + 1; j < elo.length; j++) {
                double turn = j > 2 ? 0 : j - i == 1 ? circle : -circle;
                groups.add(MadeUpGroup.two((elo[i] - elo[j] + turn) / RatingFit.ELO, ties, side / RatingFit.ELO,
                    push / RatingFit.ELO, i, j));
            }
        }
        return of(name, elo.length, false, groups);
    }

    /** Returns a league of games of three. */
    static MadeUpLeague threes(String name, double push, double... elo) {
        List<MadeUpGroup> groups = new ArrayList<>();
        for (int i = 0; i < elo.length; i++) {
            for (int j = i + 1; j < elo.length; j++) {
                for (int k = j + 1; k < elo.length; k++) {
                    groups.add(MadeUpGroup.many(natural(elo[i], elo[j], elo[k]), false, push / RatingFit.ELO, i, j,
                        k));
                }
            }
        }
        return of(name, elo.length, false, groups);
    }

    /** Returns a league of games of two between these pairs, all on one list of seeds. */
    static MadeUpLeague sharing(String name, double push, double[] elo, int[]... pairs) {
        return of(name, elo.length, false, List.of(MadeUpGroup.sharing(natural(elo), push / RatingFit.ELO, pairs)));
    }

    /** Returns a league of bots that play alone, all on the same maps. */
    static MadeUpLeague alone(String name, double... elo) {
        int[] bots = IntStream.range(0, elo.length).toArray();
        return of(name, elo.length, true, List.of(MadeUpGroup.many(natural(elo), true, 0, bots)));
    }

    private static double[] natural(double... elo) {
        return Arrays.stream(elo).map(each -> each / RatingFit.ELO).toArray();
    }

    /** Returns strengths at equal distances, the strongest first. */
    static double[] spaced(int bots, double step) {
        return IntStream.range(0, bots).mapToDouble(k -> -step * k).toArray();
    }
}
