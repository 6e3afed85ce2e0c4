package steward.lab.statistics;

import java.util.Arrays;
import java.util.List;
import steward.league.rating.Difference;
import steward.league.rating.RatingFit;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * Bars at all looks: a truth that is outside once counts as missed. All groups play in turn; the first look is after
 * the first round, then there is one after each round, later whenever there are 2% more clusters.
 *
 * @param rounds after which it ends
 */
record AnytimeCheck(MadeUpLeague league, int rounds) {

    private static final int GROWTH = 50;

    Coverage run(int threads, long leagues, long seed) throws InterruptedException {
        int bots = league.bots();
        int pairs = bots * (bots - 1) / 2;
        long[] missed = Counted.play(threads, leagues, pairs, () -> {
            List<Stratum> strata = league.groups().stream().map(MadeUpGroup::stratum).toList();
            boolean[] out = new boolean[pairs];
            return (number, counts) -> {
                play(new SplitMix64(seed + number), strata, out);
                for (int pair = 0; pair < pairs; pair++) {
                    counts[pair] += out[pair] ? 1 : 0;
                }
            };
        });
        for (int pair = 0; pair < pairs; pair++) {
            missed[pair] = leagues - missed[pair];
        }
        return Coverage.of(league, leagues, missed);
    }

    private void play(SplitMix64 random, List<Stratum> strata, boolean... out) {
        Arrays.fill(out, false);
        strata.forEach(Stratum::clear);
        RatingFit fit = league.truth();
        int due = 1;
        for (int round = 1; round <= rounds; round++) {
            for (int q = 0; q < strata.size(); q++) {
                strata.get(q).add(league.groups().get(q).draw(random), 1);
            }
            if (round == due) {
                fit = RatingFit.of(league.bots(), strata, league.pooled(), fit);
                look(fit, out);
                due = Math.max(round + 1, round + round / GROWTH);
            }
        }
    }

    private void look(RatingFit fit, boolean... out) {
        int pair = 0;
        for (int i = 0; i < league.bots(); i++) {
            for (int j = i + 1; j < league.bots(); j++) {
                if (!out[pair]) {
                    out[pair] = isOutside(fit.difference(i, j), league.truth().rating(i) - league.truth().rating(j));
                }
                pair++;
            }
        }
    }

    /** True if the truth is outside the anytime bar. That is never below two standard deviations, which saves time. */
    static boolean isOutside(Difference found, double truth) {
        double error = Math.abs(found.elo() - truth);
        return error > 2 * RatingFit.ELO * Math.sqrt(found.variance()) && error > found.anytimeBar();
    }
}
