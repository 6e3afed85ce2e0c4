package steward.contest;

import java.util.List;
import steward.match.MatchResult;

/**
 * Results of one bot in many games.
 *
 * <p>Points of a game: the share of the others that are ranked below, with half of those on the same rank; between two
 * bots 1 for a win, 1/2 for a draw, 0 for a loss. Where each plays alone, the results on the same map count so; a bot
 * without others has no points.
 *
 * <p>A game in which all bots failed in the same turn counts for its points as its result says, a draw between two; but
 * it is counted apart, since it does not tell which bot is better.
 *
 * @param games     with a result
 * @param wins      alone on the first rank
 * @param draws     on the first rank with others
 * @param losses    the rest
 * @param allFailed games in which all bots failed in the same turn, in none of the three above
 * @param faults    games in which the bot failed as a program
 * @param points    per game, 0..1; NaN without games, and without other bots
 * @param score     the game's own, per game; NaN without games
 */
public record Tally(int games, int wins, int draws, int losses, int allFailed, int faults, double points,
                    double score) {

    /** The standard normal quantile of 0.975. */
    private static final double Z = 1.959963984540054;

    /** The tally of a bot, by its place in the call. */
    static Tally of(Contest contest, List<Series.Played> played, int entrant) {
        if (contest.isAlone()) {
            return AloneTally.of(contest, played, entrant);
        }
        int games = 0;
        int wins = 0;
        int draws = 0;
        int allFailed = 0;
        int faults = 0;
        double points = 0;
        double score = 0;
        for (Series.Played game : played) {
            MatchResult result = game.result();
            if (result == null) {
                continue;
            }
            int player = game.playerOf(contest, entrant);
            games++;
            boolean first = result.players().get(player).rank() == 0;
            allFailed += game.allFailed() ? 1 : 0;
            wins += !game.allFailed() && result.winner() == player ? 1 : 0;
            draws += !game.allFailed() && result.winner() != player && first ? 1 : 0;
            faults += result.players().get(player).fault() != null ? 1 : 0;
            points += points(result, player);
            score += result.players().get(player).score();
        }
        return new Tally(games, wins, draws, games - wins - draws - allFailed, allFailed, faults, points / games,
            score / games);
    }

    static double points(MatchResult result, int player) {
        int rank = result.players().get(player).rank();
        double points = 0;
        int others = result.players().size() - 1;
        for (MatchResult.PlayerResult other : result.players()) {
            points += other.rank() > rank ? 1 : other.rank() == rank ? 0.5 : 0;
        }
        return (points - 0.5) / others;
    }

    /** The lower end of the 95% interval of {@link #points}. */
    public double low() {
        return Math.max(0, centre() - halfWidth());
    }

    /** The upper end. */
    public double high() {
        return Math.min(1, centre() + halfWidth());
    }

    /*
     * Wilson's score interval (E. B. Wilson, "Probable inference, the law of succession, and statistical inference",
     * Journal of the American Statistical Association 22, 1927): all p with |points - p| <= z sqrt(p (1 - p) / n).
     * It is made for wins and losses. With points between 0 and 1 it is too wide rather than too narrow, because no
     * variable in 0..1 with the mean p has a variance above p (1 - p). It counts games as independent.
     */
    private double centre() {
        return (points + Z * Z / (2 * games)) / (1 + Z * Z / games);
    }

    private double halfWidth() {
        return Z / (1 + Z * Z / games) * Math.sqrt(points * (1 - points) / games + Z * Z / (4.0 * games * games));
    }
}
