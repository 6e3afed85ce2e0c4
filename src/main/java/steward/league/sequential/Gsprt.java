package steward.league.sequential;

import steward.league.rating.AnytimeBar;

/**
 * The generalized sequential probability ratio test (M. Van den Bergh, "A practical introduction to the GSPRT" and
 * "Normalized Elo", https://www.cantate.be/Fishtest, as the Stockfish testing project uses it): is the difference
 * {@code elo0} (H0) or {@code elo1} (H1)? The logarithm of the ratio of the greatest likelihoods under either, for
 * normally distributed means with unknown variance, from n observations of mean m and variance v:
 *
 * <pre>
 *   logistic     n/2 log((v + (m - s0)^2) / (v + (m - s1)^2))        s = 1 / (1 + 10^(-elo/400))
 *   normalized   n/2 log((1 + (t - t0)^2) / (1 + (t - t1)^2))        t = (m - 1/2) / sqrt(v)
 * </pre>
 *
 * Normalized Elo measures the difference of scores in standard deviations of a game: 800 / ln 10 points are one. A
 * standard deviation of a game is that of an observation times the root of its number of games, so that t0 =
 * elo0 ln 10 / 800 sqrt(games).
 *
 * @param elo0  of H0
 * @param elo1  of H1, more than elo0
 * @param alpha probability to accept H1 where H0 is true, 0..1/2
 * @param beta  probability to accept H0 where H1 is true, likewise
 * @param model what Elo means
 */
public record Gsprt(double elo0, double elo1, double alpha, double beta, Model model) {

    /** Normalized Elo of one standard deviation of a game. */
    static final double NORMALIZED = 800 / 2.302585092994046;
    private static final double LOGISTIC = 400 / 2.302585092994046;

    /** What Elo means. */
    public enum Model {
        /** By the spread of the scores. */
        NORMALIZED,
        /** By the mean score. */
        LOGISTIC
    }

    /** How it stands. */
    public enum State {
        /** The difference is rather elo0 or less. */
        H0,
        /** It is rather elo1 or more. */
        H1,
        /** Not decided. */
        OPEN
    }

    /** Checks the bounds. */
    public Gsprt {
        if (!(elo0 < elo1) || !(alpha > 0 && alpha < 0.5) || !(beta > 0 && beta < 0.5)) {
            throw new IllegalArgumentException("elo0 " + elo0 + ", elo1 " + elo1 + ", alpha " + alpha + ", beta "
                + beta);
        }
    }

    /** H0 is accepted at or below this. */
    public double lower() {
        return StrictMath.log(beta / (1 - alpha));
    }

    /** H1 is accepted at or above this. */
    public double upper() {
        return StrictMath.log((1 - beta) / alpha);
    }

    /** The logarithm of the likelihood ratio. */
    public double ratio(ScoreCounts scores) {
        if (scores.observations() == 0) {
            return 0;
        }
        double deviation = Math.sqrt(scores.variance());
        double t = (scores.mean() - 0.5) / deviation;
        double one = t - bound(elo0, scores.games(), deviation);
        double other = t - bound(elo1, scores.games(), deviation);
        return scores.observations() / 2.0 * StrictMath.log((1 + one * one) / (1 + other * other));
    }

    /** A hypothesis in standard deviations of an observation. */
    double bound(double elo, int games, double deviation) {
        return model == Model.NORMALIZED ? elo / NORMALIZED * Math.sqrt(games)
            : (1 / (1 + StrictMath.exp(-elo / LOGISTIC)) - 0.5) / deviation;
    }

    /** How it stands. */
    public State state(ScoreCounts scores) {
        double ratio = ratio(scores);
        return ratio >= upper() ? State.H1 : ratio <= lower() ? State.H0 : State.OPEN;
    }

    /** The difference in Elo of this model that a mean score is. */
    public double elo(double mean, ScoreCounts scores) {
        return model == Model.NORMALIZED
            ? (mean - 0.5) / Math.sqrt(scores.variance() * scores.games()) * NORMALIZED
            : mean <= 0 ? Double.NEGATIVE_INFINITY : mean >= 1 ? Double.POSITIVE_INFINITY
            : LOGISTIC * StrictMath.log(mean / (1 - mean));
    }

    /**
     * Half the width of the bar of the mean score that holds at all looks, and so where the test has stopped; infinite
     * with fewer than two observations.
     */
    public static double anytimeBar(ScoreCounts scores) {
        long n = scores.observations();
        if (n < 2) {
            return Double.POSITIVE_INFINITY;
        }
        return AnytimeBar.of(scores.variance() / (n - 1) / (SLOPE * SLOPE), n - 1, AnytimeBar.ALPHA) * SLOPE;
    }

    /** Of the score by the natural rating, where both bots are even. */
    private static final double SLOPE = 0.25;
}
