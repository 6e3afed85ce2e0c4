package steward.lab.statistics;

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
 * Check of bars and of a stop rule on simulated leagues, scheduled as a real league is: in turn, adaptively or all
 * against one, until the rule ends it or after a number of decisions.
 *
 * @param league   the bots; where all play against one, with its {@link MadeUpLeague#hero}
 * @param adaptive whether it is paired by what is learnt
 * @param rule     that ends it, or {@link StopRule#NONE}
 * @param most     decisions after which it ends in any case
 */
record ScheduleCheck(MadeUpLeague league, boolean adaptive, StopRule rule, int most) {

    /** Lag of a league as it is made. */
    private static final int LAG = 64;

    /**
     * Result of a check.
     *
     * @param leagues   how many were played
     * @param decisions until the end, on average
     * @param rarest    clusters of the group that was paired least, on average
     * @param right     share of the leagues in which all that the rule found is true
     * @param looks     by difference: how often its anytime bar held at all looks
     * @param end       how often it held at the end
     * @param fixed     how often the bar for a fixed number held at the end
     */
    record Outcome(MadeUpLeague league, long leagues, double decisions, double rarest, double right, long[] looks,
                   long[] end, long... fixed) {

        Coverage atLooks(Coverage.Among among) {
            return Coverage.of(league, among, leagues, looks);
        }

        Coverage atEnd(Coverage.Among among) {
            return Coverage.of(league, among, leagues, end);
        }

        Coverage ofFixed(Coverage.Among among) {
            return Coverage.of(league, among, leagues, fixed);
        }
    }

    Outcome run(int threads, long leagues, long seed) throws InterruptedException {
        int bots = league.bots();
        int pairs = bots * (bots - 1) / 2;
        int groups = league.groups().size();
        long[] counts = Counted.play(threads, leagues, 2 + 3 * pairs + groups, () -> {
            List<Stratum> strata = league.groups().stream().map(MadeUpGroup::stratum).toList();
            return (number, sums) -> new Play(strata, new SplitMix64(seed + number)).play(sums);
        });
        long[] looks = Arrays.copyOfRange(counts, 2, 2 + pairs);
        for (int k = 0; k < pairs; k++) {
            looks[k] = leagues - looks[k];
        }
        long rarest = Arrays.stream(counts, 2 + 3 * pairs, counts.length).min().orElse(0);
        return new Outcome(league, leagues, (double) counts[0] / leagues, (double) rarest / leagues,
            (double) counts[1] / leagues, looks, Arrays.copyOfRange(counts, 2 + pairs, 2 + 2 * pairs),
            Arrays.copyOfRange(counts, 2 + 2 * pairs, 2 + 3 * pairs));
    }

    /** Play of one simulated league. */
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
                : league.hero() < 0 ? Pairing.roundRobin(versions, players)
                : Pairing.gauntlet(versions, players, league.hero());
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
            while (decision < most && !isOver(decision)) {
                pairing.next(decision);
                int[] group = pairing.choose();
                pairing.made(1, group);
                int place = place(group);
                unknown.add(new int[] {place, league.groups().get(place).draw(random)});
                decision++;
            }
            if (decision == most) {
                before(decision);
                look();
            }
            count(decision, sums);
        }

        private boolean isOver(int decision) {
            if (!rule.isAny() || decision < LAG || !Looks.isLook(decision)) {
                return false;
            }
            Ratings found = before(decision - LAG + 1);
            look();
            return rule.isMet(found);
        }

        private void count(int decisions, long... sums) {
            sums[0] += decisions;
            sums[1] += isRight() ? 1 : 0;
            int next = 2;
            for (boolean each : out) {
                sums[next++] += each ? 1 : 0;
            }
            for (int i = 0; i < league.bots(); i++) {
                for (int j = i + 1; j < league.bots(); j++) {
                    Difference found = fit.difference(i, j);
                    double error = Math.abs(found.elo() - truth(i, j));
                    sums[next] += error <= found.anytimeBar() ? 1 : 0;
                    sums[next + out.length] += error <= found.bar() ? 1 : 0;
                    next++;
                }
            }
            next += out.length;
            for (Stratum stratum : strata) {
                sums[next++] += stratum.clusters();
            }
        }

        private double truth(int i, int j) {
            return league.truth().rating(i) - league.truth().rating(j);
        }

        private void look() {
            int pair = 0;
            for (int i = 0; i < league.bots(); i++) {
                for (int j = i + 1; j < league.bots(); j++) {
                    out[pair] = out[pair] || AnytimeCheck.isOutside(fit.difference(i, j), truth(i, j));
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

        /** True if all that was found of neighbours is true. */
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
