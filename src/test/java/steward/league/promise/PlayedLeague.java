package steward.league.promise;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
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

/** League of made-up bots while it is played. Its results are counts: 1 for an estimate that holds the truth. */
final class PlayedLeague {

    /** Lag of a league as it is made. */
    private static final int LAG = 64;
    /** Where pairings are played in turn, looks come after each round, later whenever there are 2% more. */
    private static final int GROWTH = 50;
    /** In Elo: what is left of no difference by rounding. */
    private static final double EQUAL = 1e-6;

    private final MadeUpLeague league;
    private final List<Stratum> strata;
    private final SplitMix64 random;
    private final List<Integer> versions;
    /** Games that are being played, each with the numbers of its group and of its way. */
    private final Deque<int[]> unknown = new ArrayDeque<>();
    /** By pair of bots: 1 if anytime bars held at all looks. */
    private final long[] held;
    private RatingFit fit;
    private int known;

    PlayedLeague(MadeUpLeague league, SplitMix64 random) {
        this.league = league;
        this.random = random;
        strata = league.groups().stream().map(group -> group.stratum(0)).toList();
        versions = IntStream.range(0, league.truth().bots()).boxed().toList();
        held = league.pairs().stream().mapToLong(pair -> 1).toArray();
        fit = league.truth();
    }

    /** Returns the means of the counts of so many trials, each with random numbers of its own. */
    static double[] means(long trials, Function<SplitMix64, LongStream> trial) {
        long[] sums = LongStream.range(0, trials).parallel()
            .mapToObj(number -> trial.apply(new SplitMix64(21 + number)).toArray())
            .reduce((one, other) -> IntStream.range(0, one.length).mapToLong(k -> one[k] + other[k]).toArray())
            .orElseThrow();
        return LongStream.of(sums).mapToDouble(sum -> (double) sum / trials).toArray();
    }

    private void fit() {
        fit = RatingFit.of(league.truth().bots(), strata, league.groups().get(0).weight() == 1, fit);
    }

    /** Plays so many clusters of each group, or as many in the mean. */
    LongStream fixed(int clusters, boolean adaptive) {
        if (adaptive) {
            schedule(StopRule.NONE, true, clusters * strata.size());
        } else {
            IntStream.range(0, clusters * strata.size()).map(k -> k / clusters).forEach(group ->
                strata.get(group).add(league.groups().get(group).draw(random), 1));
            fit();
        }
        return estimates();
    }

    /** Counts the bars of differences that hold, by pair; then those of ratings, by bot; then ranges of ranks. */
    private LongStream estimates() {
        RankRange[] ranks = RankRange.all(fit);
        return Stream.of(
            league.pairs().stream().map(pair ->
                new ScoreTest(fit).bounded(pair[0], pair[1]).holds(league.truth(pair))),
            versions.stream().map(bot -> {
                double[] mean = fit.meanWeights(bot);
                double zero = versions.stream().filter(k -> mean[k] > 0)
                    .mapToDouble(k -> mean[k] * league.truth().rating(k)).sum();
                return new ScoreTest(fit).boundedToMean(bot).holds(league.truth().rating(bot) - zero);
            }),
            versions.stream().map(bot -> ranks[bot].best() <= 1 + ahead(bot, 1)
                && ranks[bot].worst() >= versions.size() - ahead(bot, -1))
        ).flatMap(each -> each).mapToLong(holds -> holds ? 1 : 0);
    }

    /** Number of bots that are better, or with the sign -1 worse. */
    private long ahead(int bot, int sign) {
        return versions.stream().filter(other -> sign * league.truth(other, bot) > EQUAL).count();
    }

    /**
     * Plays as a league is scheduled, so many seeds or until a rule is met. Counts the seeds; then 1 if all is true
     * that is said of the order; then, by pair, anytime bars that held at all looks.
     */
    LongStream until(StopRule rule, boolean adaptive, int most) {
        int seeds = schedule(rule, adaptive, most);
        return LongStream.concat(LongStream.of(seeds, isRight(rule) ? 1 : 0), LongStream.of(held));
    }

    private int schedule(StopRule rule, boolean adaptive, int most) {
        int players = league.groups().get(0).bots().length;
        boolean inTurn = !adaptive && !rule.isAny();
        Pairing pairing = adaptive ? new AdaptivePairing(versions, players, LAG, rule, this::before)
            : league.hero() < 0 ? Pairing.roundRobin(versions, players)
            : Pairing.gauntlet(versions, players, league.hero());
        for (int decision = 0, due = strata.size(); decision <= most; decision++) {
            if (inTurn ? decision == due : decision >= LAG && Looks.isLook(decision)) {
                due += strata.size() * Math.max(1, decision / strata.size() / GROWTH);
                Ratings found = before(inTurn ? decision : decision - LAG + 1);
                look();
                if (rule.isAny() && rule.isMet(found, this::meet)) {
                    return decision;
                }
            }
            int group = inTurn ? decision % strata.size() : group(pairing, decision);
            unknown.add(new int[] {group, league.groups().get(group).draw(random)});
        }
        before(most);
        return most;
    }

    private int group(Pairing pairing, int decision) {
        pairing.next(decision);
        int[] bots = pairing.choose(any -> true);
        pairing.made(1, bots);
        return IntStream.range(0, strata.size()).filter(group ->
            Arrays.equals(league.groups().get(group).bots(), bots)).findFirst().orElseThrow();
    }

    /** Counts anytime bars: a truth that is outside of one once is missed. */
    private void look() {
        for (int k = 0; k < held.length; k++) {
            double truth = league.truth(league.pairs().get(k));
            Difference found = fit.difference(league.pairs().get(k)[0], league.pairs().get(k)[1]);
            boolean holds = found.isOneSided() ? found.holds(truth)
                : !(Math.abs(found.elo() - truth) > found.anytimeBar());
            held[k] &= holds ? 1 : 0;
        }
    }

    private Ratings before(int decision) {
        if (known < decision) {
            for (; known < decision; known++) {
                strata.get(unknown.element()[0]).add(unknown.remove()[1], 1);
            }
            fit();
        }
        return new Ratings(versions, fit);
    }

    private boolean meet(int one, int other) {
        return league.groups().stream().anyMatch(group -> Arrays.binarySearch(group.bots(), one) >= 0
            && Arrays.binarySearch(group.bots(), other) >= 0);
    }

    private boolean isRight(StopRule rule) {
        Ratings found = new Ratings(versions, fit);
        List<Integer> order = found.order();
        List<StopRule.Order> orders = rule.orders(found, order, this::meet);
        return IntStream.range(0, orders.size()).allMatch(k -> {
            double truth = league.truth(order.get(k), order.get(k + 1));
            return orders.get(k) == StopRule.Order.ORDERED ? truth > 0
                : orders.get(k) != StopRule.Order.EQUAL || Math.abs(truth) <= rule.equal();
        });
    }
}
