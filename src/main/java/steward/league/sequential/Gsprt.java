package steward.league.sequential;

import java.util.Arrays;

/**
 * Generalized sequential probability ratio test: decides between a difference {@code elo0} (H0) and {@code elo1} (H1).
 * It follows M. Van den Bergh, "A practical introduction to the GSPRT" and "Comments on normalized Elo",
 * https://www.cantate.be/Fishtest, as fastchess and the Stockfish testing project use it. Each score that an
 * observation can have is a cell; with n[i] observations in cell i, an empty cell counted as {@value #EMPTY}
 * observations, the logarithm of the ratio is
 *
 * <pre>
 *   LLR = sum of n[i] log(p1[i] / p0[i])
 *   logistic      p0, p1: the most likely chances with the mean s0, s1            s = 1 / (1 + 10^(-elo/400))
 *   normalized    p0, p1: those whose mean is 1/2 + t0 d, 1/2 + t1 d              d their standard deviation
 * </pre>
 *
 * see {@link ConstrainedFrequencies}. The cells of a seed with two games are 0, 1/4, 1/2, 3/4, 1, also where none came;
 * those of a seed with one game or more than two are 0, 1/2, 1 and every score that came. Nothing is decided on fewer
 * than {@value #LEAST} observations.
 *
 * <p>Normalized Elo measures the difference of scores in standard deviations of a game: 800 / ln 10 points are one. A
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

    /** Observations that an empty cell counts as. */
    static final double EMPTY = 1e-3;
    /** Observations before anything is decided. */
    public static final int LEAST = 10;
    /** Normalized Elo of one standard deviation of a game. */
    static final double NORMALIZED = 800 / 2.302585092994046;
    private static final double LOGISTIC = 400 / 2.302585092994046;

    /** Scale of Elo. */
    public enum Model {
        /** By the spread of the scores. */
        NORMALIZED,
        /** By the mean score. */
        LOGISTIC
    }

    /** State of a test. */
    public enum State {
        /** The difference is rather elo0 or less. */
        H0,
        /** It is rather elo1 or more. */
        H1,
        /** Not decided. */
        OPEN
    }

    public Gsprt {
        if (!(elo0 < elo1) || !(alpha > 0 && alpha < 0.5) || !(beta > 0 && beta < 0.5)) {
            throw new IllegalArgumentException("elo0 " + elo0 + ", elo1 " + elo1 + ", alpha " + alpha + ", beta "
                + beta);
        }
    }

    /** A test of two mean scores, each more than 0 and less than 1. */
    public static Gsprt ofScores(double zero, double one, double alpha, double beta) {
        return new Gsprt(logistic(zero), logistic(one), alpha, beta, Model.LOGISTIC);
    }

    /** H0 is accepted at or below this. */
    public double lower() {
        return StrictMath.log(beta / (1 - alpha));
    }

    /** H1 is accepted at or above this. */
    public double upper() {
        return StrictMath.log((1 - beta) / alpha);
    }

    public double ratio(ScoreCounts scores) {
        if (scores.observations() == 0) {
            return 0;
        }
        double[] logs = logs(scores);
        double ratio = 0;
        for (int k = 0; k < logs.length; k++) {
            ratio += scores.count(k) * logs[k];
        }
        return ratio;
    }

    /** The logarithm of p1 / p0 in each cell. */
    double[] logs(ScoreCounts scores) {
        return logs(scores, scores.frequencies());
    }

    /** The logarithm of p1 / p0 in each cell, if the scores come with these frequencies. */
    double[] logs(ScoreCounts scores, double... frequencies) {
        double[] zero = likely(scores, elo0, frequencies);
        double[] one = likely(scores, elo1, frequencies);
        for (int k = 0; k < one.length; k++) {
            one[k] = StrictMath.log(one[k] / zero[k]);
        }
        return one;
    }

    /** The most likely chances of the scores with a difference, if they come with these frequencies. */
    double[] likely(ScoreCounts scores, double elo, double... frequencies) {
        ConstrainedFrequencies likely = new ConstrainedFrequencies(scores.values(), frequencies);
        return model == Model.NORMALIZED ? likely.ofDeviations(elo / NORMALIZED * Math.sqrt(scores.games()))
            : likely.ofMean(score(elo));
    }

    /** The greatest change of the logarithm by one more observation; a few more change hardly how great it is. */
    public double greatestStep(ScoreCounts scores) {
        return Arrays.stream(logs(scores)).map(Math::abs).max().orElseThrow();
    }

    /** Returns how it stands. */
    public State state(ScoreCounts scores) {
        if (scores.observations() < LEAST) {
            return State.OPEN;
        }
        double ratio = ratio(scores);
        return ratio >= upper() ? State.H1 : ratio <= lower() ? State.H0 : State.OPEN;
    }

    /** Range of the difference in Elo of this model, corrected for stopping. Expects observations. */
    public StoppedRange range(ScoreCounts scores) {
        return StoppedRange.of(this, scores);
    }

    /** The mean score of a difference in logistic Elo. */
    static double score(double elo) {
        return 1 / (1 + StrictMath.exp(-elo / LOGISTIC));
    }

    /** The difference in logistic Elo of a mean score. */
    static double logistic(double mean) {
        return LOGISTIC * StrictMath.log(mean / (1 - mean));
    }
}
