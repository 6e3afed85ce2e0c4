package steward.league.selfcheck;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import steward.league.Pairing;
import steward.league.pairing.AdaptivePairing;
import steward.league.pairing.Looks;
import steward.league.pairing.StopRule;
import steward.league.rating.Difference;
import steward.league.rating.RatingFit;
import steward.league.rating.Ratings;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * A league until a rule ends it, paired in turn or by what is learnt.
 *
 * @param league   the bots
 * @param adaptive how it is paired
 * @param rule     that ends it
 * @param most     decisions after which it ends in any case
 */
record AdaptiveCheck(MadeUpLeague league, boolean adaptive, StopRule rule, int most) {

    /** That of a league as it is made. */
    private static final int LAG = 64;

    /**
     * What came out.
     *
     * @param decisions until the end, on average
     * @param right     share of the leagues in which all that the rule found is true
     * @param coverage  how often the bars of single differences held at all looks
     * @param atEnd     how often they held at the end
     */
    record Outcome(double decisions, double right, Coverage coverage, Coverage atEnd) {
    }

    Outcome run(int threads, long leagues, long seed) throws InterruptedException {
        int bots = league.bots();
        int pairs = bots * (bots - 1) / 2;
        long[] counts = Counted.play(threads, leagues, 2 + 2 * pairs, () -> {
            List<Stratum> strata = league.groups().stream().map(MadeUpGroup::stratum).toList();
            return (number, sums) -> new Play(strata, new SplitMix64(seed + number)).play(sums);
        });
        long[] always = Arrays.copyOfRange(counts, 2, 2 + pairs);
        for (int k = 0; k < pairs; k++) {
            always[k] = leagues - always[k];
        }
        return new Outcome((double) counts[0] / leagues, (double) counts[1] / leagues,
            Coverage.of(league, leagues, always),
            Coverage.of(league, leagues, Arrays.copyOfRange(counts, 2 + pairs, 2 + 2 * pairs)));
    }

    /** One league. */
    private final class Play {

        private final List<Stratum> strata;
        private final SplitMix64 random;
        private final Pairing pairing;
        private final Deque<int[]> unknown = new ArrayDeque<>();
        private final List<Integer> versions = IntStream.range(0, league.bots()).boxed().toList();
        private final double[] weights = new double[league.bots()];
        private final boolean[] out = new boolean[league.bots() * (league.bots() - 1) / 2];
        private RatingFit fit = league.truth();
        private int known;

        Play(List<Stratum> strata, SplitMix64 random) {
            this.strata = strata;
            this.random = random;
            strata.forEach(Stratum::clear);
            Arrays.fill(weights, 1.0 / weights.length);
            int players = league.groups().get(0).bots().length;
            IntFunction<Ratings> ratings = this::before;
            pairing = adaptive ? new AdaptivePairing(versions, players, LAG, rule, ratings)
                : Pairing.roundRobin(versions, players);
        }

        private Ratings before(int decision) {
            if (known < decision) {
                for (; known < decision; known++) {
                    int[] next = unknown.remove();
                    strata.get(next[0]).add(next[1], 1);
                }
                fit = RatingFit.of(league.bots(), strata, league.pooled(), fit);
            }
            return new Ratings(versions, fit, weights);
        }

        void play(long... sums) {
            int decision = 0;
            boolean met = false;
            for (; decision < most && !met; decision++) {
                if (Looks.isLook(decision) && decision >= LAG) {
                    Ratings found = before(decision - LAG + 1);
                    look();
                    met = rule.isMet(found);
                    if (met) {
                        break;
                    }
                }
                pairing.next(decision);
                int[] group = pairing.choose();
                pairing.made(1, group);
                int place = place(group);
                unknown.add(new int[] {place, league.groups().get(place).draw(random)});
            }
            sums[0] += decision;
            sums[1] += isRight() ? 1 : 0;
            for (int k = 0; k < out.length; k++) {
                sums[2 + k] += out[k] ? 1 : 0;
            }
            int pair = 0;
            for (int i = 0; i < league.bots(); i++) {
                for (int j = i + 1; j < league.bots(); j++) {
                    sums[2 + out.length + pair++] += isOutside(i, j) ? 0 : 1;
                }
            }
        }

        private boolean isOutside(int i, int j) {
            Difference found = fit.difference(i, j);
            return Math.abs(found.elo() - truth(i, j)) > found.anytimeBar();
        }

        private double truth(int i, int j) {
            return league.truth().rating(i) - league.truth().rating(j);
        }

        private void look() {
            int pair = 0;
            for (int i = 0; i < league.bots(); i++) {
                for (int j = i + 1; j < league.bots(); j++) {
                    out[pair] = out[pair] || isOutside(i, j);
                    pair++;
                }
            }
        }

        private int place(int... group) {
            int place = 0;
            while (!Arrays.equals(league.groups().get(place).bots(), group)) {
                place++;
            }
            return place;
        }

        /** Whether what was found of neighbours is true. */
        private boolean isRight() {
            Ratings found = new Ratings(versions, fit, weights);
            List<Integer> order = StopRule.order(found);
            List<StopRule.Order> orders = new ArrayList<>(rule.orders(found, order));
            for (int k = 0; k < orders.size(); k++) {
                double truth = truth(order.get(k), order.get(k + 1));
                if (orders.get(k) == StopRule.Order.ORDERED && truth <= 0
                    || orders.get(k) == StopRule.Order.EQUAL && Math.abs(truth) > rule.equal()) {
                    return false;
                }
            }
            return true;
        }
    }
}
