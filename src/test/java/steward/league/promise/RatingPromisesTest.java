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
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.pairing.StopRule;
import steward.league.rating.Ratings;
import steward.league.sequential.Gsprt;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.schema.PublishedTable;

/**
 * Tables of how often bars, order and sequential tests held, each row within four standard deviations of the promise:
 * {@code docs/tables/rating.md}, with {@code -Psteward.games=20000} leagues of each kind in hours.
 */
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class RatingPromisesTest {

    private static final long LEAGUES = Long.getLong("steward.games", TestSize.of(20, 40));
    /** With few leagues two more than four deviations: the binomial distribution is skew. */
    private static final double FOUR = 4 * Math.sqrt(0.95 * 0.05 / LEAGUES) + 2.0 / LEAGUES;
    private static final int MOST = 5_000_000;
    private static final StopRule RANKED = new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL);

    private final List<String> lines = new ArrayList<>();

    private void row(Object... cells) {
        lines.add(Arrays.stream(cells).map(cell -> cell instanceof Double share ? percent(share) : cell.toString())
            .collect(Collectors.joining(" | ", "| ", " |")));
    }

    private void head(String columns) {
        row((Object[]) columns.split("; "));
        lines.add("|" + "---|".repeat(columns.split("; ").length));
    }

    private static String percent(double share) {
        return Double.isFinite(share) ? number("%.2f", 100 * share) : "-";
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    private void within(double least, double most, double... shares) {
        for (double share : shares) {
            assertTrue(!Double.isFinite(share) || share >= least - FOUR && share <= most + FOUR,
                () -> share + " in " + lines.get(lines.size() - 1));
        }
    }

    // ---- bars ------------------------------------------------------------------------------------

    private void fixed(MadeUpLeague league, String size, int... clusters) {
        PlayedLeagues found = PlayedLeagues.of(league, LEAGUES, play -> play.fixed(clusters));
        double[] bars = found.atFixedNumbers(null);
        double ranks = found.least(0, league.bots());
        double ratings = found.least(league.bots(), 2 * league.bots());
        row(league.name(), size, bars[0], bars[1], bars[2], ratings, ranks);
        boolean jumps = league.bots() == 2 && league.name().endsWith("apart");
        within(jumps ? 0.929 : 0.942, clusters[0] < 30 ? 1 : jumps ? 0.9723 : 0.957, bars[0], bars[1]);
        within(0.929, 1, bars[2], ratings, ranks);
    }

    @Test
    @Tag("sized")
    void barsAtAFixedNumberOfClusters() throws IOException {
        head("league; clusters of a pairing; scores 5..95%: least; most; other scores: least; ratings: least; "
            + "ranks: least");
        for (int clusters : new int[] {5, 10, 30, 100, 300}) {
            MadeUpLeague.small().forEach(league -> fixed(league, "" + clusters,
                league.groups().stream().mapToInt(group -> clusters).toArray()));
        }
        for (MadeUpLeague league : List.of(MadeUpLeague.TRIO, MadeUpLeague.MIXED, MadeUpLeague.THREES)) {
            SplitMix64 random = new SplitMix64(21);
            fixed(league, "30 to 400, unequal",
                league.groups().stream().mapToInt(group -> 30 + random.nextInt(371)).toArray());
        }
        for (int clusters : new int[] {5, 30}) {
            fixed(MadeUpLeague.LARGE, "" + clusters,
                MadeUpLeague.LARGE.groups().stream().mapToInt(group -> clusters).toArray());
        }
        PublishedTable.write("rating.md", "fixed", lines);
    }

    private static DoubleSummaryStatistics shares(DoubleUnaryOperator bars, int from, int to) {
        return IntStream.iterate(from, elo -> elo < to, elo -> elo + 5).mapToDouble(bars::applyAsDouble)
            .summaryStatistics();
    }

    private void exact(int clusters, String name, DoubleUnaryOperator bars, double farthest) {
        DoubleSummaryStatistics near = shares(bars, 0, 300);
        DoubleSummaryStatistics far = shares(bars, 300, 515);
        row(clusters, name, near.getMin(), near.getAverage(), near.getMax(), far.getMin(), far.getAverage(),
            far.getMax(), farthest);
    }

    @Test
    @Tag("sized")
    void barsOfTwoBotsAreAsNearAsWholeGamesLetThem() throws IOException {
        head("clusters; bars; 0 to 300 Elo apart: least; mean; most; 300 to 510 Elo apart: least; mean; most; "
            + "510 to 1300: least");
        for (int clusters : TestSize.isWhole() ? new int[] {30, 40, 60, 100, 200, 300} : new int[] {30}) {
            DoubleUnaryOperator ours = TwoBots.ours(clusters);
            exact(clusters, "these", ours, shares(ours, 515, 1305).getMin());
            DoubleSummaryStatistics far = shares(ours, 300, 515);
            assertTrue(shares(ours, 0, 300).getMin() > 0.942 && far.getMin() > 0.936 && far.getMax() < 0.98,
                lines::toString);
        }
        for (int clusters : TestSize.isWhole() ? new int[] {30, 40, 60} : new int[] {30}) {
            exact(clusters, "Wilson's", TwoBots.wilson(2 * clusters), Double.NaN);
            exact(clusters, "mid-P", TwoBots.midP(2 * clusters), Double.NaN);
            exact(clusters, "nearest of all", TwoBots.nearest(2 * clusters), Double.NaN);
        }
        // Binomial chances of 60 games, summed up by a program of a few lines of Python, at 440 and 445 Elo.
        DoubleSummaryStatistics nearest = shares(TwoBots.nearest(60), 300, 515);
        assertEquals(0.9412327816503685, nearest.getMin(), 1e-12);
        assertEquals(0.9620295697011976, nearest.getMax(), 1e-12);
        PublishedTable.write("rating.md", "exact", lines);
    }

    private void pairing(MadeUpLeague league, String pairing, boolean adaptive, int seeds) {
        PlayedLeagues found = PlayedLeagues.of(league, LEAGUES, play -> play.schedule(adaptive, StopRule.NONE, seeds));
        double rarest = found.least(2, 2 + league.groups().size());
        boolean circle = pairing.contains("compared");
        league.parts().forEach((words, hero) -> {
            double[] bars = found.atFixedNumbers(hero);
            row(league.name(), pairing + words, seeds, number("%.1f", rarest), bars[0], bars[1], bars[2]);
            within(circle ? 0 : 0.942, circle ? 0.05 : rarest < 30 ? 1 : 0.957, bars[0], bars[1]);
        });
    }

    private void pairings(MadeUpLeague league, int[] seeds, int... heroes) {
        for (int each : seeds) {
            pairing(league, "adaptive", true, each);
        }
        for (int hero : heroes) {
            MadeUpLeague gauntlet = league.gauntlet(hero);
            for (int clusters : new int[] {10, 30, 100, 300}) {
                pairing(gauntlet, "gauntlet of bot " + (hero + 1), false, clusters * gauntlet.groups().size());
            }
        }
    }

    @Test
    @Tag("sized")
    void barsHoweverBotsArePaired() throws IOException {
        head("league; pairing; seeds; clusters of the rarest pairing, mean; scores 5..95%: least; most; "
            + "other scores: least");
        pairings(MadeUpLeague.TRIO, new int[] {30, 100, 300, 1000}, 0);
        pairings(MadeUpLeague.MIXED, new int[] {150, 600, 1500, 4000}, 0, 3);
        pairings(MadeUpLeague.THREES, new int[] {100, 300, 1000}, 0);
        pairing(MadeUpLeague.TRIO.gauntlet(0).comparedWith(MadeUpLeague.TRIO.truth()),
            "gauntlet, compared with round robin", false, 200);
        PublishedTable.write("rating.md", "pairings", lines);
    }

    @Test
    @Tag("sized")
    void anytimeBarsHoldAtAllLooks() throws IOException {
        head("league; clusters of a pairing; scores 5..95%: least; most; other scores: least");
        List<MadeUpLeague> leagues = new ArrayList<>(MadeUpLeague.small());
        leagues.add(MadeUpLeague.LARGE);
        for (MadeUpLeague league : leagues) {
            int rounds = league.bots() == 2 ? 3000 : league.bots() < 5 ? 1000 : league.bots() < 30 ? 300 : 16;
            PlayedLeagues found = PlayedLeagues.of(league, LEAGUES, play -> play.rounds(rounds));
            double[] bars = found.atAllLooks(null);
            row(league.name(), "1 to " + rounds, bars[0], bars[1], bars[2]);
            within(0.95, 1, bars);
        }
        PublishedTable.write("rating.md", "anytime", lines);
    }

    private void rule(MadeUpLeague league, String pairing, StopRule rule) {
        PlayedLeagues found = PlayedLeagues.of(league, LEAGUES,
            play -> play.schedule(pairing.equals("adaptive"), rule, MOST));
        double order = rule.ranked() ? found.mean(1) : Double.NaN;
        league.parts().forEach((words, hero) -> {
            double looks = found.atAllLooks(hero)[0];
            row(league.name(), pairing + words, rule.ranked() ? "--until-ranked --equal " + Math.round(rule.equal())
                : "--until-bars " + Math.round(rule.bars()), Math.round(found.mean(0)), looks,
                found.atTheEnd(hero)[0], order);
            within(0.95, 1, looks, order);
        });
    }

    @Test
    @Tag("sized")
    void whatIsSaidOfTheOrderWhereARuleEndsALeagueIsTrue() throws IOException {
        head("league; pairing; rule; seeds, mean; bars at all looks: least; bars at the end: least; order true");
        for (MadeUpLeague league : TestSize.isWhole() ? List.of(MadeUpLeague.TRIO, MadeUpLeague.MIXED,
                MadeUpLeague.THREES) : List.of(MadeUpLeague.THREES)) {
            int middle = league.bots() / 2;
            for (String pairing : List.of("round robin", "adaptive", "gauntlet of bot " + (middle + 1))) {
                MadeUpLeague played = pairing.startsWith("g") ? league.gauntlet(middle) : league;
                rule(played, pairing, new StopRule(50, false, StopRule.USUAL_EQUAL));
                rule(played, pairing, new StopRule(Double.NaN, true, 30));
            }
        }
        for (MadeUpLeague league : MadeUpLeague.WON) {
            rule(league, "round robin", RANKED);
            rule(league, "adaptive", RANKED);
        }
        PublishedTable.write("rating.md", "rules", lines);
    }

    // ---- sequential tests, adaptive pairing ------------------------------------------------------

    private void sprt(Gsprt.Model model, double elo0, double elo1, double at, boolean isMixed, int alike) {
        PlayedTests found = PlayedTests.of(new Gsprt(elo0, elo1, 0.05, 0.05, model), LEAGUES, at,
            isMixed ? 0.33 : 0, isMixed ? 100 : 0, alike);
        row(model.name().toLowerCase(Locale.ROOT) + " " + Math.round(elo0) + " to " + Math.round(elo1),
            (isMixed ? "draws, seeds of 100 Elo" : "no draws") + (alike == 0 ? "" : ", the first " + alike
            + " seeds even"), Math.round(at), number("%.4f", found.accepted()), Math.round(found.mean()),
            Math.round(found.theory()), number("%.3f", found.mean() / found.theory()), found.held());
        within(0.95, 1, at >= elo1 ? found.accepted() : 1 - found.accepted());
        within(0.89, 1, found.held());
        assertEquals(1, found.mean() / found.theory(), 0.06 + 4 / Math.sqrt(LEAGUES), () -> lines.toString());
    }

    @Test
    @Tag("sized")
    void sequentialTestsErrAsRarelyAsTheySay() throws IOException {
        head("Elo; games; truth; H1 accepted; seeds, mean; theory; of theory; range held");
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double[] elo : TestSize.isWhole() ? new double[][] {{0, 20}, {0, 10}, {-10, 0}, {0, 5}}
                    : new double[][] {{0, 20}}) {
                for (int k = 0; k < 4; k++) {
                    sprt(model, elo[0], elo[1], elo[k % 2], k > 1, 0);
                }
            }
        }
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double at : TestSize.isWhole() ? new double[] {200, 500, 1000} : new double[] {200}) {
                for (double[] elo : new double[][] {{0, 10, at}, {0, 10, -at}, {0, 50, at}, {0, 50, -at},
                    {at - 50, at, at - 50}, {at - 50, at, at}}) {
                    sprt(model, elo[0], elo[1], elo[2], false, 0);
                }
            }
            sprt(model, 0, 10, 0, true, 30);
            sprt(model, 0, 10, 10, true, 30);
        }
        PublishedTable.write("rating.md", "sprt", lines);
    }

    /** 90% with alpha = beta = 0.05, at both hypotheses and between; beyond them at least so much. */
    @Test
    @Tag("sized")
    void rangesHoldInNineOfTenTests() {
        int trials = TestSize.of(100, 4000);
        double chance = 4 * Math.sqrt(0.09 / trials);
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double at : TestSize.isWhole() ? new double[] {-30, 0, 15, 30, 70, 150} : new double[] {0, 70}) {
                double held = PlayedTests.of(new Gsprt(0, 30, 0.05, 0.05, model), trials, at, 0.3, 0, 0).held();
                assertTrue(held > 0.88 - chance && held < (at < 0 || at > 30 ? 1 : 0.92) + chance,
                    model + " at " + at + ": held in " + held);
            }
        }
    }

    @Test
    @Tag("campaign")
    void adaptivePairingNeedsFewerGames() throws IOException {
        head("steps between neighbours, Elo; round robin, seeds; adaptive, seeds; share; order true; strengths known");
        long whole = Math.max(2, LEAGUES / 200);
        double[] even = new double[15];
        Arrays.fill(even, 35);
        for (double[] each : new double[][] {{10, 60, 20, 50, 30, 40, 15, 55, 25, 45, 35, 60, 20, 50, 30},
            {60, 57, 53, 50, 46, 43, 39, 36, 32, 29, 25, 22, 18, 14, 10}, drawn(1), drawn(2), drawn(3), even}) {
            MadeUpLeague league = MadeUpLeague.sixteen(each);
            double turns = PlayedLeagues.of(league, whole, play -> play.schedule(false, RANKED, MOST)).mean(0);
            PlayedLeagues learnt = PlayedLeagues.of(league, whole, play -> play.schedule(true, RANKED, MOST));
            row(Arrays.stream(each).mapToObj(step -> "" + Math.round(step)).collect(Collectors.joining(" ")),
                Math.round(turns), Math.round(learnt.mean(0)), number("%.2f", learnt.mean(0) / turns), learnt.mean(1),
                number("%.2f", BestAllocation.share(league)));
            assertTrue(learnt.mean(0) < 0.9 * turns, lines::toString);
        }
        PublishedTable.write("rating.md", "adaptive", lines);
    }

    private static double[] drawn(long seed) {
        SplitMix64 random = new SplitMix64(seed);
        return IntStream.range(0, 15).mapToDouble(step -> 10 + random.nextInt(51)).toArray();
    }

    /**
     * Of three bots the last is far away: only the first two are in doubt, whose variance is c1/n1 + c2/n2 + c3/n3. The
     * least sum of n for it is (sqrt(c1) + sqrt(c2) + sqrt(c3))^2, that of equal n is 3 (c1 + c2 + c3).
     */
    @Test
    @Tag("sized")
    void theBestAllocationHasItsClosedForm() {
        MadeUpLeague league = MadeUpLeague.pairs("three", new double[] {10, 0, -600}, 0, 0, 0, 0);
        double[] parts = new Ratings(List.of(0, 1, 2), league.truth()).parts(List.of(new int[] {0, 1})).values()
            .stream().mapToDouble(part -> part).toArray();
        double roots = Arrays.stream(parts).map(Math::sqrt).sum();
        assertEquals(roots * roots / (3 * Arrays.stream(parts).sum()), BestAllocation.share(league), 1e-3);
    }
}
