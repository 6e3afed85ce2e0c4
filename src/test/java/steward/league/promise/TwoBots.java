package steward.league.promise;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import steward.league.rating.Difference;
import steward.league.rating.RatingFit;
import steward.league.rating.ScoreTest;
import steward.league.rating.Stratum;

/**
 * How often the bar of the difference of two bots without ties holds, exactly, by how many Elo they are apart: the sum
 * of the chances of all ways in which their games can go. This jumps with the strength, as results come into their bars
 * and leave them.
 */
final class TwoBots {

    private static final double Z = 1.959963984540054;

    /** Share of bars that hold, by the expected score and the chances of each number of games won. */
    private interface Bar {
        double share(double score, double... chances);
    }

    private TwoBots() { }

    /** Our bars after so many clusters of two games. */
    static DoubleUnaryOperator ours(int clusters) {
        Stratum stratum = MadeUpLeague.two(0).strata().get(0);
        Difference[][] found = new Difference[clusters + 1][clusters + 1];
        double[] factorials = new double[clusters + 1];
        for (int won = 0; won <= clusters; won++) {
            factorials[won] = won < 2 ? 0 : factorials[won - 1] + StrictMath.log(won);
            for (int shared = 0; won + shared <= clusters; shared++) {
                stratum.clear();
                stratum.add(0, clusters - won - shared);
                stratum.add(1, shared);
                stratum.add(2, won);
                found[won][shared] = new ScoreTest(RatingFit.of(2, List.of(stratum), false)).bounded(0, 1);
            }
        }
        return elo -> {
            MadeUpLeague league = MadeUpLeague.two(elo);
            double[] logs = Arrays.stream(league.groups().get(0).chances()).map(StrictMath::log).toArray();
            double share = 0;
            for (int won = 0; won <= clusters; won++) {
                for (int shared = 0; won + shared <= clusters; shared++) {
                    int lost = clusters - won - shared;
                    share += !found[won][shared].holds(league.truth(0, 1)) ? 0 : StrictMath.exp(factorials[clusters]
                        - factorials[won] - factorials[shared] - factorials[lost] + won * logs[2] + shared * logs[1]
                        + lost * logs[0]);
                }
            }
            return share;
        };
    }

    /** Bars that follow from the score alone. */
    private static DoubleUnaryOperator others(int games, Bar bar) {
        return elo -> {
            double score = 1 / (1 + StrictMath.pow(10, -elo / 400));
            double[] chances = {1};
            for (int game = 1; game <= games; game++) {
                double[] more = new double[game + 1];
                for (int won = 0; won < game; won++) {
                    more[won] += chances[won] * (1 - score);
                    more[won + 1] += chances[won] * score;
                }
                chances = more;
            }
            return bar.share(score, chances);
        };
    }

    /** E. B. Wilson, "Probable inference", Journal of the American Statistical Association 22, 1927. */
    static DoubleUnaryOperator wilson(int games) {
        return others(games, (score, chances) -> IntStream.rangeClosed(0, games)
            .filter(won -> Math.abs((double) won / games - score) <= Z * Math.sqrt(score * (1 - score) / games))
            .mapToDouble(won -> chances[won]).sum());
    }

    /** The observed count counts half, and each side may have 2.5% (mid-P: H. O. Lancaster, Biometrika 36, 1949). */
    static DoubleUnaryOperator midP(int games) {
        return others(games, (score, chances) -> {
            double share = 0;
            double below = 0;
            for (double chance : chances) {
                share += Math.abs(below + chance / 2 - 0.5) <= 0.475 ? chance : 0;
                below += chance;
            }
            return share;
        });
    }

    /** For each strength the scores with a chance nearest to 95%: no bar that grows with the score is better. */
    static DoubleUnaryOperator nearest(int games) {
        return others(games, (score, chances) -> {
            double best = 0;
            for (int first = 0; first <= games; first++) {
                double share = 0;
                for (int last = first; last <= games; last++) {
                    share += chances[last];
                    best = Math.abs(share - 0.95) < Math.abs(best - 0.95) ? share : best;
                }
            }
            return best;
        });
    }
}
