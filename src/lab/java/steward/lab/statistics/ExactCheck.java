package steward.lab.statistics;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import steward.league.rating.Difference;
import steward.league.rating.RatingFit;
import steward.league.rating.ScoreTest;
import steward.league.rating.Stratum;

/**
 * Exact coverage of the bar of the difference of two bots without ties: the sum of the chances of all ways in which
 * their games can go. Scores are whole numbers of games, so that this jumps with the strength as results come into
 * their bars and leave them.
 *
 * @param clusters how many are played, each of two games
 */
record ExactCheck(int clusters) {

    /** Between strengths, in Elo. */
    static final double STEP = 5;

    /** A way in which the games can go: how many seeds one won, shared and lost; and what is found then. */
    private record Way(int won, int shared, int lost, Difference found) { }

    /**
     * Over some strengths.
     *
     * @param least how often the bar holds where it does least often
     * @param mean  on average
     * @param most  where it does most often
     */
    record Outcome(double least, double mean, double most) {

        static Outcome of(List<Double> shares) {
            DoubleSummaryStatistics sums = shares.stream().mapToDouble(Double::doubleValue).summaryStatistics();
            return new Outcome(sums.getMin(), sums.getAverage(), sums.getMax());
        }
    }

    /** For the differences in Elo {@code from}, {@code from} + 5, ... below {@code to}. */
    Outcome run(double from, double to) {
        List<Way> ways = ways();
        List<Double> shares = new ArrayList<>();
        for (double elo = from; elo < to; elo += STEP) {
            shares.add(share(ways, league(elo)));
        }
        return Outcome.of(shares);
    }

    private static MadeUpLeague league(double elo) {
        return MadeUpLeague.pairs("two", new double[] {elo, 0}, 0, 0, 0, 0);
    }

    /** The patterns of a seed are lost, shared, won: they are in the order of their points. */
    private List<Way> ways() {
        Stratum stratum = league(0).groups().get(0).stratum();
        List<Way> ways = new ArrayList<>();
        for (int won = 0; won <= clusters; won++) {
            for (int shared = 0; won + shared <= clusters; shared++) {
                int lost = clusters - won - shared;
                stratum.clear();
                stratum.add(0, lost);
                stratum.add(1, shared);
                stratum.add(2, won);
                ways.add(new Way(won, shared, lost,
                    new ScoreTest(RatingFit.of(2, List.of(stratum), false)).bounded(0, 1)));
            }
        }
        return ways;
    }

    private double share(List<Way> ways, MadeUpLeague league) {
        double truth = league.truth().rating(0) - league.truth().rating(1);
        double[] logs = league.groups().get(0).chances();
        for (int k = 0; k < logs.length; k++) {
            logs[k] = StrictMath.log(logs[k]);
        }
        double[] factorials = new double[clusters + 1];
        for (int k = 2; k <= clusters; k++) {
            factorials[k] = factorials[k - 1] + StrictMath.log(k);
        }
        double share = 0;
        for (Way way : ways) {
            if (way.found().holds(truth)) {
                share += StrictMath.exp(factorials[clusters] - factorials[way.won()] - factorials[way.shared()]
                    - factorials[way.lost()] + way.won() * logs[2] + way.shared() * logs[1] + way.lost() * logs[0]);
            }
        }
        return share;
    }
}
