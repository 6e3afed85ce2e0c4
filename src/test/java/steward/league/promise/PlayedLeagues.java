package steward.league.promise;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.Consumer;
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

/** Leagues of the same bots, one that is played or the sum of many, and how often bars held in them. */
final class PlayedLeagues {

    /** Lag of a league as it is made. */
    private static final int LAG = 64;
    private static final long SEED = 21;
    /** Looks come after each round, later whenever there are 2% more. */
    private static final int GROWTH = 50;
    /** In Elo: what is left of no difference by rounding. */
    private static final double EQUAL = 1e-6;

    private final MadeUpLeague league;
    private final List<Stratum> strata;
    private final SplitMix64 random;
    private final List<Integer> versions;
    /** Games that are being played, each with the numbers of its group and of its way. */
    private final Deque<int[]> unknown = new ArrayDeque<>();
    /** By pair of bots: how often anytime bars held at all looks, at the end, and bars for a fixed number there. */
    private final long[][] held;
    /** Sums of what else was counted. */
    private long[] more = {};
    private int leagues = 1;
    private RatingFit fit;
    private int known;

    private PlayedLeagues(MadeUpLeague league, long number) {
        this.league = league;
        strata = league.strata();
        random = new SplitMix64(SEED + number);
        versions = IntStream.range(0, league.bots()).boxed().toList();
        held = new long[3][league.pairs()];
        Arrays.fill(held[0], 1);
        fit = league.truth();
    }

    /** Plays so many. */
    static PlayedLeagues of(MadeUpLeague league, long leagues, Consumer<PlayedLeagues> course) {
        return LongStream.range(0, leagues).parallel().mapToObj(number -> {
            PlayedLeagues play = new PlayedLeagues(league, number);
            course.accept(play);
            return play;
        }).reduce(PlayedLeagues::plus).orElseThrow();
    }

    private PlayedLeagues plus(PlayedLeagues other) {
        Arrays.setAll(held, k -> sum(held[k], other.held[k]));
        more = sum(more, other.more);
        leagues += other.leagues;
        return this;
    }

    static long[] sum(long[] one, long... other) {
        return IntStream.range(0, one.length).mapToLong(k -> one[k] + other[k]).toArray();
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
                held[1][pair] = in ? 1 : 0;
                held[0][pair] *= held[1][pair];
                held[2][pair] = found.holds(league.truth(i, j)) ? 1 : 0;
            }
        }
    }

    /** With so many clusters of each group; counts by bot how often ranks held, and then how often ratings did. */
    void fixed(int... clusters) {
        for (int group = 0; group < clusters.length; group++) {
            draw(group, clusters[group]);
        }
        fit();
        int bots = league.bots();
        ScoreTest test = new ScoreTest(fit);
        RankRange[] ranks = RankRange.all(fit);
        more = new long[2 * bots];
        for (int i = 0, pair = 0; i < bots; i++) {
            for (int j = i + 1; j < bots; j++) {
                held[2][pair++] = test.bounded(i, j).holds(league.truth(i, j)) ? 1 : 0;
            }
            more[i] = ranks[i].best() <= 1 + ahead(i, 1) && ranks[i].worst() >= bots - ahead(i, -1) ? 1 : 0;
            double[] mean = fit.meanWeights(i);
            double zero = IntStream.range(0, mean.length).filter(k -> mean[k] > 0)
                .mapToDouble(k -> mean[k] * league.truth().rating(k)).sum();
            more[bots + i] = new Ratings(versions, fit).bounded(i).holds(league.truth().rating(i) - zero) ? 1 : 0;
        }
    }

    /** Number of bots that are better, or with the sign -1 worse. */
    private long ahead(int bot, int sign) {
        return IntStream.range(0, league.bots()).filter(other -> sign * league.truth(other, bot) > EQUAL).count();
    }

    /** All groups in turn. */
    void rounds(int rounds) {
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

    /** As a league is scheduled; counts decisions, leagues in which the order is true, and clusters by group. */
    void schedule(boolean adaptive, StopRule rule, int most) {
        int players = league.groups().get(0).bots().length;
        Pairing pairing = adaptive ? new AdaptivePairing(versions, players, LAG, rule, this::before)
            : league.hero() < 0 ? Pairing.roundRobin(versions, players)
            : Pairing.gauntlet(versions, players, league.hero());
        int decision = 0;
        boolean over = false;
        while (decision < most && !over) {
            pairing.next(decision);
            int[] group = pairing.choose(any -> true);
            pairing.made(1, group);
            int place = 0;
            while (!Arrays.equals(league.groups().get(place).bots(), group)) {
                place++;
            }
            unknown.add(new int[] {place, league.groups().get(place).draw(random)});
            decision++;
            if (rule.isAny() && decision >= LAG && Looks.isLook(decision)) {
                Ratings found = before(decision - LAG + 1);
                look();
                over = rule.isMet(found, this::isPair);
            }
        }
        if (!over) {
            before(decision);
            look();
        }
        more = LongStream.concat(LongStream.of(decision, isRight(rule) ? 1 : 0),
            strata.stream().mapToLong(Stratum::clusters)).toArray();
    }

    private Ratings before(int decision) {
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
        List<StopRule.Order> orders = List.copyOf(rule.orders(found, order, this::isPair));
        return IntStream.range(0, orders.size()).allMatch(k -> {
            double truth = league.truth(order.get(k), order.get(k + 1));
            return switch (orders.get(k)) {
                case ORDERED -> truth > 0;
                case EQUAL -> Math.abs(truth) <= rule.equal();
                default -> true;
            };
        });
    }

    double mean(int which) {
        return (double) more[which] / leagues;
    }

    /** Least of the means from one to before another. */
    double least(int from, int to) {
        return IntStream.range(from, to).mapToDouble(this::mean).min().orElseThrow();
    }

    double[] atAllLooks(Boolean hero) {
        return shares(held[0], hero);
    }

    double[] atTheEnd(Boolean hero) {
        return shares(held[1], hero);
    }

    double[] atFixedNumbers(Boolean hero) {
        return shares(held[2], hero);
    }

    /**
     * Shares of leagues in which bars held.
     *
     * @param hero whether of pairs with the bot against which all play, or of the others; {@code null} for all
     * @return the least and the most over pairs with an expected score of 5 to 95%, and the least over others; infinite
     *         if there are none
     */
    private double[] shares(long[] each, Boolean hero) {
        DoubleSummaryStatistics usual = new DoubleSummaryStatistics();
        DoubleSummaryStatistics others = new DoubleSummaryStatistics();
        for (int i = 0, pair = 0; i < league.bots(); i++) {
            for (int j = i + 1; j < league.bots(); j++, pair++) {
                double score = league.truth().expected(i, j);
                if (!Double.isNaN(score) && (hero == null || hero == (i == league.hero() || j == league.hero()))) {
                    (score < 0.05 || score > 0.95 ? others : usual).accept((double) each[pair] / leagues);
                }
            }
        }
        return new double[] {usual.getMin(), usual.getMax(), others.getMin()};
    }
}
