package steward.league.promise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.pairing.StopRule;
import steward.league.rating.Difference;
import steward.league.rating.RatingFit;
import steward.league.rating.ScoreTest;
import steward.league.rating.Stratum;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.StoppedRange;
import steward.match.TestSize;
import steward.schema.PublishedTable;

/**
 * Tables of how often bars, order and sequential tests held, each row within four standard deviations of the promise:
 * {@code docs/tables/rating.md}, with {@code -Psteward.games=20000} leagues of each kind in hours. It takes
 * long because a promise of frequencies needs hundreds of leagues.
 */
@Tag("slow")
@Tag("sized")
@Execution(ExecutionMode.CONCURRENT)
class RatingPromisesTest {

    private static final long LEAGUES = Long.getLong("steward.games", TestSize.of(20, 40));
    /** With few leagues two more than four deviations: the binomial distribution is skew. */
    private static final double FOUR = 4 * Math.sqrt(0.95 * 0.05 / LEAGUES) + 2.0 / LEAGUES;
    private static final double[] LOG_FACTORIALS = IntStream.range(0, 601)
        .mapToDouble(count -> IntStream.rangeClosed(1, count).mapToDouble(StrictMath::log).sum()).toArray();

    private final List<String> lines = new ArrayList<>();

    private void row(Object... cells) {
        lines.add("| " + Arrays.stream(cells).map(cell -> !(cell instanceof Double share) ? cell.toString()
            : Double.isFinite(share) ? String.format(Locale.ROOT, "%.2f", 100 * share) : "-")
            .collect(Collectors.joining(" | ")) + " |");
    }

    private void head(String columns) {
        row((Object[]) columns.split("; "));
        lines.add("|" + "---|".repeat(columns.split("; ").length));
    }

    private void within(double least, double most, double... shares) {
        for (double share : shares) {
            assertTrue(!Double.isFinite(share) || share >= least - FOUR && share <= most + FOUR,
                () -> share + " in " + lines.get(lines.size() - 1));
        }
    }

    private void fixed(MadeUpLeague league, int clusters, boolean adaptive) {
        double[] found = PlayedLeague.means(LEAGUES,
            random -> new PlayedLeague(league, random).fixed(clusters, adaptive));
        double[] bars = league.range(0, found);
        int pairs = league.pairs().size();
        int bots = league.truth().bots();
        double ratings = Arrays.stream(found, pairs, pairs + bots).min().orElseThrow();
        double ranks = Arrays.stream(found, pairs + bots, found.length).min().orElseThrow();
        row(league.name() + (adaptive ? ", adaptive" : ""), clusters, bars[0], bars[1], bars[2], ratings, ranks);
        boolean jumps = bots == 2 && league.name().endsWith("apart");
        within(jumps ? 0.929 : 0.942, clusters < (adaptive ? 100 : 30) ? 1 : jumps ? 0.9723 : 0.957, bars[0], bars[1]);
        within(0.929, 1, bars[2], ratings, ranks);
    }

    @Test
    void barsHoldAtAFixedNumberOfClusters() throws IOException {
        head("league; clusters of a pairing; scores 5..95%: least; most; other scores: least; ratings: least; "
            + "ranks: least");
        for (int clusters : new int[] {5, 10, 30, 100, 300}) {
            MadeUpLeague.small().forEach(league -> fixed(league, clusters, false));
            for (MadeUpLeague league : MadeUpLeague.KINDS) {
                fixed(league.gauntlet(0), clusters, false);
                fixed(league, clusters, true);
            }
        }
        fixed(MadeUpLeague.LARGE, 5, false);
        fixed(MadeUpLeague.LARGE, 30, false);
        PublishedTable.write("rating.md", "fixed", lines);
    }

    /** Chance that independent trials go so often in each way. */
    private static double chance(double[] chances, int... counts) {
        return StrictMath.exp(LOG_FACTORIALS[IntStream.of(counts).sum()] + IntStream.range(0, counts.length)
            .mapToDouble(way -> counts[way] * StrictMath.log(chances[way]) - LOG_FACTORIALS[counts[way]]).sum());
    }

    /**
     * Probability that the bar of two bots without ties holds after so many clusters, by the Elo that they are apart:
     * the sum of the chances of all results. It jumps with the strength, as results come into their bars or leave.
     */
    private static DoubleUnaryOperator ours(int clusters) {
        Difference[][] found = new Difference[clusters + 1][clusters + 1];
        for (int won = 0; won <= clusters; won++) {
            for (int shared = 0; won + shared <= clusters; shared++) {
                Stratum stratum = MadeUpLeague.two(0).groups().get(0).stratum(0);
                stratum.add(0, clusters - won - shared);
                stratum.add(1, shared);
                stratum.add(2, won);
                found[won][shared] = new ScoreTest(RatingFit.of(2, List.of(stratum), false)).bounded(0, 1);
            }
        }
        return elo -> {
            double[] ways = MadeUpLeague.two(elo).groups().get(0).chances();
            return IntStream.rangeClosed(0, clusters).mapToDouble(won -> IntStream.rangeClosed(0, clusters - won)
                .filter(shared -> found[won][shared].holds(elo))
                .mapToDouble(shared -> chance(ways, clusters - won - shared, shared, won)).sum()).sum();
        };
    }

    /** Chance nearest to 95% of a range of scores, for each strength: no bar that grows with the score is better. */
    private static DoubleUnaryOperator nearest(int games) {
        return elo -> {
            double points = MadeUpGroup.expected(elo);
            double[] chances = IntStream.rangeClosed(0, games)
                .mapToDouble(won -> chance(new double[] {points, 1 - points}, won, games - won)).toArray();
            double best = 0;
            for (int first = 0; first <= games; first++) {
                double share = 0;
                for (int last = first; last <= games; last++) {
                    share += chances[last];
                    best = Math.abs(share - 0.95) < Math.abs(best - 0.95) ? share : best;
                }
            }
            return best;
        };
    }

    private static DoubleSummaryStatistics shares(DoubleUnaryOperator bars, int from, int to) {
        return IntStream.iterate(from, elo -> elo < to, elo -> elo + 5).mapToDouble(bars::applyAsDouble)
            .summaryStatistics();
    }

    @Test
    void barsOfTwoBotsAreAsNearAsWholeGamesLetThem() throws IOException {
        head("clusters; 0 to 300 Elo apart: least; mean; most; 300 to 510 Elo apart: least; mean; most; nearest to 95% "
            + "that a bar can be: least; most; 510 to 1300: least");
        for (int clusters : TestSize.isWhole() ? new int[] {30, 40, 60, 100, 200, 300} : new int[] {30}) {
            DoubleUnaryOperator ours = ours(clusters);
            DoubleSummaryStatistics near = shares(ours, 0, 300);
            DoubleSummaryStatistics far = shares(ours, 300, 515);
            DoubleSummaryStatistics best = shares(nearest(2 * clusters), 300, 515);
            row(clusters, near.getMin(), near.getAverage(), near.getMax(), far.getMin(), far.getAverage(), far.getMax(),
                best.getMin(), best.getMax(), shares(ours, 515, 1305).getMin());
            assertTrue(near.getMin() > 0.942 && far.getMin() > 0.936 && far.getMax() < 0.98, lines::toString);
        }
        // Binomial chances of 60 games, summed up by a program of a few lines of Python, at 440 and 445 Elo.
        DoubleSummaryStatistics nearest = shares(nearest(60), 300, 515);
        assertEquals(0.9412327816503685, nearest.getMin(), 1e-12);
        assertEquals(0.9620295697011976, nearest.getMax(), 1e-12);
        PublishedTable.write("rating.md", "exact", lines);
    }

    private double until(MadeUpLeague league, StopRule rule, boolean adaptive) {
        int bots = league.truth().bots();
        int most = rule.isAny() ? Integer.MAX_VALUE
            : league.groups().size() * (bots == 2 ? 3000 : bots < 5 ? 1000 : bots < 30 ? 300 : 16);
        long leagues = bots == 16 ? Math.max(2, LEAGUES / 200) : LEAGUES;
        double[] found = PlayedLeague.means(leagues,
            random -> new PlayedLeague(league, random).until(rule, adaptive, most));
        // Of many pairs in few leagues the least says nothing.
        double[] bars = leagues < LEAGUES ? new double[] {Double.NaN, 0, Double.NaN} : league.range(2, found);
        double order = rule.ranked() ? found[1] : Double.NaN;
        row(league.name() + (adaptive ? ", adaptive" : ""), leagues, rule.ranked() ? "--until-ranked --equal "
            + Math.round(rule.equal()) : rule.isAny() ? "--until-bars 50" : "-", Math.round(found[0]), bars[0], bars[2],
            order);
        within(0.95, 1, bars[0], bars[2], order);
        return found[0];
    }

    @Test
    void anytimeBarsHoldAtAllLooksAndWhatIsSaidOfTheOrderIsTrue() throws IOException {
        head("league; leagues; rule; seeds, mean; scores 5..95%: least; other scores: least; order true");
        MadeUpLeague.small().forEach(league -> until(league, StopRule.NONE, false));
        until(MadeUpLeague.LARGE, StopRule.NONE, false);
        for (MadeUpLeague league : TestSize.isWhole() ? MadeUpLeague.KINDS : List.of(MadeUpLeague.THREES)) {
            for (StopRule rule : List.of(new StopRule(50, false, 0), new StopRule(Double.NaN, true, 30))) {
                until(league, rule, false);
                until(league, rule, true);
                until(league.gauntlet(league.truth().bots() / 2), rule, false);
            }
        }
        StopRule ranked = new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL);
        for (MadeUpLeague league : MadeUpLeague.ordered().subList(0, TestSize.isWhole() ? 4 : 2)) {
            double most = (league.pairs().size() < 100 ? 1.1 : 0.9) * until(league, ranked, false);
            assertTrue(until(league, ranked, true) <= most, lines::toString);
        }
        PublishedTable.write("rating.md", "looks", lines);
    }

    /** Scores of two games as often as is to be expected. */
    private static ScoreCounts truth(MadeUpGroup group) {
        ScoreCounts truth = new ScoreCounts(2);
        for (int way = 0; way < group.chances().length; way++) {
            truth.add(group.patterns()[way][1] / 2, Math.round(group.chances()[way] * 0x1p40));
        }
        return truth;
    }

    /** Plays tests. @param at the true difference, in the test's Elo */
    private void sprt(Gsprt test, double at, double drawn, double push) {
        int[][] pair = {{0, 1}};
        double apart = -2000;
        for (double step = 2000; step > 1e-12; step /= 2) {
            ScoreCounts truth = truth(MadeUpGroup.pairs(drawn, 0, push, pair, apart + step));
            boolean isBelow = test.model() == Gsprt.Model.LOGISTIC ? truth.mean() < MadeUpGroup.expected(at)
                : (truth.mean() - 0.5) / Math.sqrt(2 * truth.variance()) < at / 2 / RatingFit.ELO;
            apart += isBelow ? step : 0;
        }
        MadeUpGroup group = MadeUpGroup.pairs(drawn, 0, push, pair, apart);
        double[] found = PlayedLeague.means(LEAGUES, random -> {
            ScoreCounts counted = new ScoreCounts(2);
            while (test.state(counted) == Gsprt.State.OPEN) {
                double ratio = test.ratio(counted);
                // Observations that surely decide nothing: half of those that are needed if all go one way.
                double surely = counted.observations() < Gsprt.LEAST ? 0
                    : Math.min(test.upper() - ratio, ratio - test.lower()) / 2 / test.greatestStep(counted);
                for (int step = 0; step <= (int) surely; step++) {
                    counted.add(group.patterns()[group.draw(random)][1] / 2);
                }
            }
            StoppedRange range = test.range(counted);
            return LongStream.of(test.state(counted) == Gsprt.State.H1 ? 1 : 0, counted.observations(),
                range.low() <= at && at <= range.high() ? 1 : 0);
        });
        double theory = ExpectedLength.of(test, truth(group), 0).observations();
        row(test.model().name().toLowerCase(Locale.ROOT) + " " + Math.round(test.elo0()) + " to "
            + Math.round(test.elo1()), drawn > 0 ? "draws, seeds of 100 Elo" : "no draws", ("" + at).replace(".0", ""),
            String.format(Locale.ROOT, "%.4f", found[0]), Math.round(found[1]), Math.round(theory),
            String.format(Locale.ROOT, "%.3f", found[1] / theory), found[2]);
        within(0.95, 1, at >= test.elo1() ? found[0] : at <= test.elo0() ? 1 - found[0] : 1);
        within(0.89, Math.abs(at) <= 20 ? 0.92 : 1, found[2]);
        assertEquals(1, found[1] / theory, 0.06 + 4 / Math.sqrt(LEAGUES), lines::toString);
    }

    @Test
    void sequentialTestsErrAsRarelyAsTheySay() throws IOException {
        head("Elo; games; truth; H1 accepted; seeds, mean; theory; of theory; range held");
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double[] elo : TestSize.isWhole() ? new double[][] {{0, 20}, {0, 10}, {-10, 0}, {0, 5}}
                    : new double[][] {{0, 20}}) {
                for (double at : new double[] {elo[0], elo[1], (elo[0] + elo[1]) / 2}) {
                    sprt(new Gsprt(elo[0], elo[1], 0.05, 0.05, model), at, 0, 0);
                    sprt(new Gsprt(elo[0], elo[1], 0.05, 0.05, model), at, 0.33, 100);
                }
            }
            for (double at : TestSize.isWhole() ? new double[] {200, 500, 1000} : new double[] {200}) {
                for (double[] elo : new double[][] {{0, 10, at}, {0, 10, -at}, {0, 50, at}, {0, 50, -at},
                    {at - 50, at, at - 50}, {at - 50, at, at}}) {
                    sprt(new Gsprt(elo[0], elo[1], 0.05, 0.05, model), elo[2], 0, 0);
                }
            }
        }
        PublishedTable.write("rating.md", "sprt", lines);
    }
}
