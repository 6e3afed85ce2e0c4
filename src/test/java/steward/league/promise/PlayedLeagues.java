package steward.league.promise;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import steward.league.Pairing;
import steward.league.pairing.AdaptivePairing;
import steward.league.pairing.Looks;
import steward.league.pairing.StopRule;
import steward.league.rating.Difference;
import steward.league.rating.RankRange;
import steward.league.rating.RatingFit;
import steward.league.rating.Ratings;
import steward.league.rating.ScoreTest;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * Many leagues of the same bots, and how often bars held.
 *
 * @param looks by pair of bots: how often anytime bars held at all looks
 * @param end   how often they held at the end
 * @param fixed how often the bar for a fixed number held at the end
 * @param more  sums of what else was counted
 */
record PlayedLeagues(MadeUpLeague league, long leagues, long[] looks, long[] end, long[] fixed, long... more) {

    /** Lag of a league as it is made. */
    private static final int LAG = 64;
    private static final long SEED = 21;
    /** Looks come after each round, later whenever there are 2% more. */
    private static final int GROWTH = 50;
    /** In Elo: what is left of no difference by rounding. */
    private static final double EQUAL = 1e-6;

    /** One league. */
    private static final class Play {

        private final MadeUpLeague league;
        private final List<Stratum> strata;
        private final SplitMix64 random;
        private final List<Integer> versions;
        private final long[] looks;
        private final long[] end;
        private final long[] fixed;
        private long[] more = {};
        private RatingFit fit;
        private int known;

        Play(MadeUpLeague league, long number) {
            this.league = league;
            strata = league.strata();
            random = new SplitMix64(SEED + number);
            versions = IntStream.range(0, league.bots()).boxed().toList();
            looks = new long[league.pairs()];
            Arrays.fill(looks, 1);
            end = new long[looks.length];
            fixed = new long[looks.length];
            fit = league.truth();
        }

        void draw(int group, int clusters) {
            for (int k = 0; k < clusters; k++) {
                strata.get(group).add(league.groups().get(group).draw(random), 1);
            }
        }

        void fit() {
            fit = RatingFit.of(league.bots(), strata, league.pooled(), fit);
        }

        /** A truth that is outside of an anytime bar once counts as missed. */
        void look() {
            for (int i = 0, pair = 0; i < league.bots(); i++) {
                for (int j = i + 1; j < league.bots(); j++, pair++) {
                    Difference found = fit.difference(i, j);
                    double error = Math.abs(found.elo() - league.truth(i, j));
                    // An anytime bar is never below two standard deviations, which saves time.
                    boolean in = found.isOneSided() ? found.holds(league.truth(i, j))
                        : !(error > 2 * RatingFit.ELO * Math.sqrt(found.variance()) && error > found.anytimeBar());
                    end[pair] = in ? 1 : 0;
                    looks[pair] *= end[pair];
                    fixed[pair] = found.holds(league.truth(i, j)) ? 1 : 0;
                }
            }
        }

        void playFixed(int... clusters) {
            for (int group = 0; group < clusters.length; group++) {
                draw(group, clusters[group]);
            }
            fit();
            ScoreTest test = new ScoreTest(fit);
            RankRange[] found = RankRange.all(fit);
            more = new long[2 * league.bots()];
            for (int i = 0, pair = 0; i < league.bots(); i++) {
                int better = 0;
                int worse = 0;
                double[] mean = fit.meanWeights(i);
                double zero = IntStream.range(0, mean.length).filter(k -> mean[k] > 0)
                    .mapToDouble(k -> mean[k] * league.truth().rating(k)).sum();
                more[league.bots() + i] = new Ratings(versions, fit).bounded(i)
                    .holds(league.truth().rating(i) - zero) ? 1 : 0;
                for (int j = 0; j < league.bots(); j++) {
                    better += league.truth(j, i) > EQUAL ? 1 : 0;
                    worse += league.truth(j, i) < -EQUAL ? 1 : 0;
                    if (j > i) {
                        fixed[pair++] = test.bounded(i, j).holds(league.truth(i, j)) ? 1 : 0;
                    }
                }
                more[i] = found[i].best() <= 1 + better && found[i].worst() >= league.bots() - worse ? 1 : 0;
            }
        }

        void playRounds(int rounds) {
            for (int round = 1, due = 1; round <= rounds; round++) {
                for (int group = 0; group < strata.size(); group++) {
                    draw(group, 1);
                }
                if (round == due) {
                    fit();
                    look();
                    due = Math.max(round + 1, round + round / GROWTH);
                }
            }
        }

        void playSchedule(boolean adaptive, StopRule rule, int most) {
            Deque<int[]> unknown = new ArrayDeque<>();
            int players = league.groups().get(0).bots().length;
            Pairing pairing = adaptive ? new AdaptivePairing(versions, players, LAG, rule, at -> before(at, unknown))
                : league.hero() < 0 ? Pairing.roundRobin(versions, players)
                : Pairing.gauntlet(versions, players, league.hero());
            int decision = 0;
            boolean over = false;
            while (decision < most && !over) {
                pairing.next(decision);
                int[] group = pairing.choose();
                pairing.made(1, group);
                int place = 0;
                while (!Arrays.equals(league.groups().get(place).bots(), group)) {
                    place++;
                }
                unknown.add(new int[] {place, league.groups().get(place).draw(random)});
                decision++;
                if (rule.isAny() && decision >= LAG && Looks.isLook(decision)) {
                    Ratings found = before(decision - LAG + 1, unknown);
                    look();
                    over = rule.isMet(found, this::isPair);
                }
            }
            if (!over) {
                before(decision, unknown);
                look();
            }
            more = new long[2 + strata.size()];
            more[0] = decision;
            more[1] = isRight(rule) ? 1 : 0;
            Arrays.setAll(more, k -> k < 2 ? more[k] : strata.get(k - 2).clusters());
        }

        private Ratings before(int decision, Deque<int[]> unknown) {
            if (known < decision) {
                for (; known < decision; known++) {
                    int[] next = unknown.remove();
                    strata.get(next[0]).add(next[1], 1);
                }
                fit();
            }
            return new Ratings(versions, fit);
        }

        private boolean isPair(int one, int other) {
            return league.groups().stream().anyMatch(group -> IntStream.of(group.bots()).filter(bot -> bot == one
                || bot == other).count() == 2);
        }

        /** True if all that was found of neighbours is true. */
        private boolean isRight(StopRule rule) {
            Ratings found = new Ratings(versions, fit);
            List<Integer> order = found.order();
            List<StopRule.Order> orders = new ArrayList<>(rule.orders(found, order, this::isPair));
            return IntStream.range(0, orders.size()).allMatch(k -> {
                double truth = league.truth(order.get(k), order.get(k + 1));
                return orders.get(k) == StopRule.Order.ORDERED ? truth > 0
                    : orders.get(k) != StopRule.Order.EQUAL || Math.abs(truth) <= rule.equal();
            });
        }
    }

    /** What is done in one league. */
    private interface Course {
        void play(Play league);
    }

    private static PlayedLeagues played(MadeUpLeague league, long leagues, Course course) {
        long[][] sums = LongStream.range(0, leagues).parallel().mapToObj(number -> {
            Play play = new Play(league, number);
            course.play(play);
            return new long[][] {play.looks, play.end, play.fixed, play.more};
        }).reduce((one, other) -> IntStream.range(0, one.length).mapToObj(k -> IntStream.range(0, one[k].length)
            .mapToLong(at -> one[k][at] + other[k][at]).toArray()).toArray(long[][]::new)).orElseThrow();
        return new PlayedLeagues(league, leagues, sums[0], sums[1], sums[2], sums[3]);
    }

    /**
     * With so many clusters of each group; counts by bot how often the range had all ranks that the bot shares, and
     * then how often its rating held.
     */
    static PlayedLeagues fixed(MadeUpLeague league, long leagues, int... clusters) {
        return played(league, leagues, play -> play.playFixed(clusters));
    }

    /** All groups in turn. */
    static PlayedLeagues rounds(MadeUpLeague league, long leagues, int rounds) {
        return played(league, leagues, play -> play.playRounds(rounds));
    }

    /** Scheduled as a league is; counts decisions, leagues in which the order is true, and clusters by group. */
    static PlayedLeagues scheduled(MadeUpLeague league, long leagues, boolean adaptive, StopRule rule, int most) {
        return played(league, leagues, play -> play.playSchedule(adaptive, rule, most));
    }

    double mean(int which) {
        return (double) more[which] / leagues;
    }

    /**
     * Shares of leagues in which bars held.
     *
     * @param hero whether of pairs with the bot against which all play, or of the others; {@code null} for all
     * @return the least and the most over pairs with an expected score of 5 to 95%, and the least over others, or NaN
     */
    double[] shares(long[] held, Boolean hero) {
        double[] shares = {Double.NaN, Double.NaN, Double.NaN};
        for (int i = 0, pair = 0; i < league.bots(); i++) {
            for (int j = i + 1; j < league.bots(); j++, pair++) {
                double share = (double) held[pair] / leagues;
                double score = league.truth().expected(i, j);
                int at = score < 0.05 || score > 0.95 ? 2 : 0;
                if (!Double.isNaN(score) && (hero == null || hero == (i == league.hero() || j == league.hero()))) {
                    shares[at] = Double.isNaN(shares[at]) ? share : Math.min(shares[at], share);
                    shares[1] = at == 2 ? shares[1] : Double.isNaN(shares[1]) ? share : Math.max(shares[1], share);
                }
            }
        }
        return shares;
    }
}
