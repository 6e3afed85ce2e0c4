package steward.league.pairing;

import java.util.List;
import steward.league.rating.AnytimeBar;
import steward.league.rating.Difference;
import steward.league.rating.RatingFit;
import steward.league.rating.Ratings;

/**
 * Estimate of the games that a bot needs until the anytime bar of its rating is narrow enough. A bar shrinks with the
 * square root of the number of games. A bot that has won or lost nearly everything has a bound instead of a bar; once
 * it has as many games as an even bot needs, nobody waits for it.
 *
 * @param bar    half the width of its anytime bar in Elo; NaN for a bot that has none
 * @param games  that it has played
 * @param needed games in all, expected; infinite for a bot that is not waited for
 * @param wanted half the width that is asked for
 */
public record BarNeed(int version, double bar, double games, double needed, double wanted) {

    /** True if the bar can become narrow enough, and is not yet. */
    public boolean isWaitedFor() {
        return needed < Double.POSITIVE_INFINITY && !(bar <= wanted);
    }

    /** True if the bot has a bound in place of a bar, although it has the games that an even bot needs. */
    public boolean isBeyondReach() {
        return needed == Double.POSITIVE_INFINITY;
    }

    /** Returns the needs of all versions, in the order of the table. */
    public static List<BarNeed> of(Ratings ratings, double wanted) {
        double even = even(ratings.versions().size(), wanted);
        return ratings.order().stream().map(version -> {
            double games = ratings.games(version);
            double anytime = ratings.isAlone(version) || ratings.isExtreme(version) ? Difference.MOST_BAR
                : ratings.rating(version).anytimeBar();
            double bar = Difference.isKnown(anytime) ? anytime : Double.NaN;
            double needed = !Double.isNaN(bar) ? games * (bar / wanted) * (bar / wanted)
                : games < even ? even : Double.POSITIVE_INFINITY;
            return new BarNeed(version, bar, games, needed, wanted);
        }).toList();
    }

    /**
     * Returns the games of one of some even bots that play a round robin without ties, until its bar is so wide. With n
     * games each, the variance of a rating is 4/n ((bots - 1) / bots)^2: that of n even games, less its part in the
     * mean.
     */
    public static double even(int bots, double wanted) {
        double low = 1;
        double high = 1e9;
        while (high > low * 1.001) {
            double middle = Math.sqrt(low * high);
            double own = (bots - 1.0) / bots;
            double bar = AnytimeBar.of(4 / middle * own * own, middle, AnytimeBar.ALPHA);
            boolean isNarrow = RatingFit.ELO * bar <= wanted;
            low = isNarrow ? low : middle;
            high = isNarrow ? middle : high;
        }
        return high;
    }
}
