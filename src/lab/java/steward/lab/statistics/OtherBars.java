package steward.lab.statistics;

import java.util.ArrayList;
import java.util.List;

/**
 * Bars of two bots that follow from the score alone, computed for all strengths as {@link ExactCheck} does for ours:
 * those that statistics has for a share, and the best that any could do.
 *
 * @param games that are played, without ties
 */
record OtherBars(int games) {

    private static final double WANTED = 0.95;
    private static final double TAIL = 0.025;
    private static final double Z = 1.959963984540054;

    /** For a strength, how often it is in the bar. */
    private interface Share {
        double of(double score, double... chances);
    }

    /** E. B. Wilson, "Probable inference", Journal of the American Statistical Association 22, 1927. */
    ExactCheck.Outcome wilson(double from, double to) {
        return run(from, to, (score, chances) -> {
            double share = 0;
            for (int won = 0; won <= games; won++) {
                double apart = (double) won / games - score;
                share += apart * apart <= Z * Z * score * (1 - score) / games ? chances[won] : 0;
            }
            return share;
        });
    }

    /**
     * Checks bars for which the observed count counts half, and each side may have 2.5% (mid-P: H. O. Lancaster,
     * Biometrika 36, 1949).
     */
    ExactCheck.Outcome midP(double from, double to) {
        return run(from, to, (score, chances) -> {
            double share = 0;
            double below = 0;
            for (double chance : chances) {
                double upTo = below + chance / 2;
                share += upTo >= TAIL && upTo <= 1 - TAIL ? chance : 0;
                below += chance;
            }
            return share;
        });
    }

    /**
     * For each strength that range of scores whose chance is nearest to 95%, whatever the ranges of others are. A bar
     * holds at a strength if the score is in a range; so no bar that grows with the score can do better.
     */
    ExactCheck.Outcome best(double from, double to) {
        return run(from, to, (score, chances) -> {
            double best = 0;
            for (int first = 0; first <= games; first++) {
                double share = 0;
                for (int last = first; last <= games; last++) {
                    share += chances[last];
                    best = Math.abs(share - WANTED) < Math.abs(best - WANTED) ? share : best;
                }
            }
            return best;
        });
    }

    private ExactCheck.Outcome run(double from, double to, Share share) {
        List<Double> shares = new ArrayList<>();
        for (double elo = from; elo < to; elo += ExactCheck.STEP) {
            double score = 1 / (1 + StrictMath.pow(10, -elo / 400));
            shares.add(share.of(score, chances(score)));
        }
        return ExactCheck.Outcome.of(shares);
    }

    /** Of each number of games won. */
    private double[] chances(double score) {
        double[] chances = {1};
        for (int game = 1; game <= games; game++) {
            double[] more = new double[game + 1];
            for (int won = 0; won < game; won++) {
                more[won] += chances[won] * (1 - score);
                more[won + 1] += chances[won] * score;
            }
            chances = more;
        }
        return chances;
    }
}
