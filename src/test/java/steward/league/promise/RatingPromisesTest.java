package steward.league.promise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.league.pairing.StopRule;
import steward.league.rating.RatingFit;
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
class RatingPromisesTest {

    private static final long LEAGUES = Long.getLong("steward.games", TestSize.of(20, 40));
    /** With few leagues two more than four deviations: the binomial distribution is skew. */
    private static final double FOUR = 4 * Math.sqrt(0.95 * 0.05 / LEAGUES) + 2.0 / LEAGUES;
    private static final int MOST = 5_000_000;

    private final List<String> lines = new ArrayList<>();

    private void row(Object... cells) {
        lines.add(Arrays.stream(cells).map(cell -> cell instanceof Double share ? percent(share) : cell.toString())
            .collect(Collectors.joining(" | ", "| ", " |")));
    }

    private void head(String... columns) {
        row((Object[]) columns);
        lines.add("|" + "---|".repeat(columns.length));
    }

    private static String percent(double share) {
        return Double.isNaN(share) ? "-" : String.format(Locale.ROOT, "%.2f", 100 * share);
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    private void within(double least, double most, double... shares) {
        for (double share : shares) {
            assertTrue(Double.isNaN(share) || share >= least - FOUR && share <= most + FOUR,
                () -> share + " in " + lines.get(lines.size() - 1));
        }
    }

    // ---- bars ------------------------------------------------------------------------------------

    private void fixed(MadeUpLeague league, String size, int... clusters) {
        PlayedLeagues found = PlayedLeagues.fixed(league, LEAGUES, clusters);
        double[] bars = found.shares(found.fixed(), null);
        double ranks = IntStream.range(0, league.bots()).mapToDouble(found::mean).min().orElseThrow();
        double ratings = IntStream.range(league.bots(), 2 * league.bots()).mapToDouble(found::mean).min().orElseThrow();
        row(league.name(), size, bars[0], bars[1], bars[2], ratings, ranks);
        boolean jumps = league.bots() == 2 && league.name().endsWith("apart");
        within(jumps ? 0.929 : 0.942, clusters[0] < 30 ? 1 : jumps ? 0.9723 : 0.957, bars[0], bars[1]);
        within(0.929, 1, bars[2], ratings, ranks);
    }

    @Test
    @Tag("sized")
    void barsAtAFixedNumberOfClusters() throws IOException {
        head("league", "clusters of a pairing", "scores 5..95%: least", "most", "other scores: least", "ratings: least",
            "ranks: least");
        BiFunction<MadeUpLeague, Integer, int[]> even = (league, clusters) -> {
            int[] all = new int[league.groups().size()];
            Arrays.fill(all, clusters);
            return all;
        };
        for (int clusters : new int[] {5, 10, 30, 100, 300}) {
            MadeUpLeague.small().forEach(league -> fixed(league, "" + clusters, even.apply(league, clusters)));
            MadeUpLeague.logistic().forEach(league -> fixed(league, "" + clusters, even.apply(league, clusters)));
        }
        for (MadeUpLeague league : List.of(MadeUpLeague.trio(), MadeUpLeague.mixed(), MadeUpLeague.threes())) {
            SplitMix64 random = new SplitMix64(21);
            fixed(league, "30 to 400, unequal", IntStream.range(0, league.groups().size())
                .map(k -> 30 + random.nextInt(371)).toArray());
        }
        for (int clusters : new int[] {5, 30}) {
            fixed(MadeUpLeague.large(), "" + clusters, even.apply(MadeUpLeague.large(), clusters));
        }
        PublishedTable.write("rating.md", "fixed", lines);
    }

    private void exact(int clusters, String bars, DoubleSummaryStatistics near, DoubleSummaryStatistics far,
                       double beyond) {
        row(clusters, bars, near.getMin(), near.getAverage(), near.getMax(), far.getMin(), far.getAverage(),
            far.getMax(), beyond);
    }

    @Test
    @Tag("sized")
    void barsOfTwoBotsAreAsNearAsWholeGamesLetThem() throws IOException {
        head("clusters", "bars", "0 to 300 Elo apart: least", "mean", "most", "300 to 510 Elo apart: least", "mean",
            "most", "510 to 1300: least");
        for (int clusters : TestSize.isWhole() ? new int[] {30, 40, 60, 100, 200, 300} : new int[] {30}) {
            DoubleSummaryStatistics near = TwoBots.ours(clusters, 0, 300);
            DoubleSummaryStatistics far = TwoBots.ours(clusters, 300, 515);
            exact(clusters, "these", near, far, TwoBots.ours(clusters, 515, 1305).getMin());
            assertTrue(near.getMin() > 0.942 && far.getMin() > 0.936 && far.getMax() < 0.98, lines::toString);
        }
        for (int clusters : TestSize.isWhole() ? new int[] {30, 40, 60} : new int[] {30}) {
            int games = 2 * clusters;
            exact(clusters, "Wilson's", TwoBots.wilson(games, 0, 300), TwoBots.wilson(games, 300, 515), Double.NaN);
            exact(clusters, "mid-P", TwoBots.midP(games, 0, 300), TwoBots.midP(games, 300, 515), Double.NaN);
            exact(clusters, "nearest of all", TwoBots.nearest(games, 0, 300), TwoBots.nearest(games, 300, 515),
                Double.NaN);
        }
        // Binomial chances of 60 games, summed up by a program of a few lines of Python, at 440 and 445 Elo.
        assertEquals(0.9412327816503685, TwoBots.nearest(60, 300, 515).getMin(), 1e-12);
        assertEquals(0.9620295697011976, TwoBots.nearest(60, 300, 515).getMax(), 1e-12);
        PublishedTable.write("rating.md", "exact", lines);
    }

    private void pairing(MadeUpLeague league, String pairing, boolean adaptive, int seeds) {
        PlayedLeagues found = PlayedLeagues.scheduled(league, LEAGUES, adaptive, StopRule.NONE, seeds);
        double rarest = IntStream.range(2, found.more().length).mapToDouble(found::mean).min().orElseThrow();
        boolean circle = pairing.contains("compared");
        each(league, (hero, words) -> {
            double[] bars = found.shares(found.fixed(), hero);
            row(league.name(), pairing + words, seeds, number("%.1f", rarest), bars[0], bars[1], bars[2]);
            within(circle ? 0 : 0.942, circle ? 0.05 : rarest < 30 ? 1 : 0.957, bars[0], bars[1]);
        });
    }

    private interface Row {
        void of(Boolean hero, String words);
    }

    /** Differences with the bot of a gauntlet stand apart. */
    private static void each(MadeUpLeague league, Row row) {
        if (league.hero() < 0) {
            row.of(null, "");
        } else {
            row.of(true, ": with it");
            row.of(false, ": others");
        }
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
        head("league", "pairing", "seeds", "clusters of the rarest pairing, mean", "scores 5..95%: least", "most",
            "other scores: least");
        pairings(MadeUpLeague.trio(), new int[] {30, 100, 300, 1000}, 0);
        pairings(MadeUpLeague.mixed(), new int[] {150, 600, 1500, 4000}, 0, 3);
        pairings(MadeUpLeague.threes(), new int[] {100, 300, 1000}, 0);
        pairing(MadeUpLeague.trio().gauntlet(0).comparedWith(MadeUpLeague.trio().truth()),
            "gauntlet, compared with round robin", false, 200);
        PublishedTable.write("rating.md", "pairings", lines);
    }

    @Test
    @Tag("sized")
    void anytimeBarsHoldAtAllLooks() throws IOException {
        head("league", "clusters of a pairing", "scores 5..95%: least", "most", "other scores: least");
        List<MadeUpLeague> leagues = new ArrayList<>(MadeUpLeague.small());
        leagues.addAll(MadeUpLeague.logistic());
        leagues.add(MadeUpLeague.large());
        for (MadeUpLeague league : leagues) {
            int rounds = league.bots() == 2 ? 3000 : league.bots() < 5 ? 1000 : league.bots() < 30 ? 300 : 16;
            PlayedLeagues found = PlayedLeagues.rounds(league, LEAGUES, rounds);
            double[] bars = found.shares(found.looks(), null);
            row(league.name(), "1 to " + rounds, bars[0], bars[1], bars[2]);
            within(0.95, 1, bars);
        }
        PublishedTable.write("rating.md", "anytime", lines);
    }

    private PlayedLeagues rule(MadeUpLeague league, String pairing, boolean adaptive, StopRule rule) {
        PlayedLeagues found = PlayedLeagues.scheduled(league, LEAGUES, adaptive, rule, MOST);
        each(league, (hero, words) -> {
            double looks = found.shares(found.looks(), hero)[0];
            row(league.name(), pairing + words, rule.ranked() ? "--until-ranked --equal " + Math.round(rule.equal())
                : "--until-bars " + Math.round(rule.bars()), Math.round(found.mean(0)), looks,
                found.shares(found.end(), hero)[0], rule.ranked() ? found.mean(1) : Double.NaN);
            within(0.95, 1, looks, rule.ranked() ? found.mean(1) : 1);
        });
        return found;
    }

    @Test
    @Tag("sized")
    void whatIsSaidOfTheOrderWhereARuleEndsALeagueIsTrue() throws IOException {
        head("league", "pairing", "rule", "seeds, mean", "bars at all looks: least", "bars at the end: least",
            "order true");
        for (MadeUpLeague league : TestSize.isWhole() ? List.of(MadeUpLeague.trio(), MadeUpLeague.mixed(),
                MadeUpLeague.threes()) : List.of(MadeUpLeague.threes())) {
            int middle = league.bots() / 2;
            for (String pairing : List.of("round robin", "adaptive", "gauntlet of bot " + (middle + 1))) {
                MadeUpLeague played = pairing.startsWith("g") ? league.gauntlet(middle) : league;
                rule(played, pairing, pairing.equals("adaptive"), new StopRule(50, false, StopRule.USUAL_EQUAL));
                rule(played, pairing, pairing.equals("adaptive"), new StopRule(Double.NaN, true, 30));
            }
        }
        for (MadeUpLeague league : MadeUpLeague.won()) {
            rule(league, "round robin", false, new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL));
            rule(league, "adaptive", true, new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL));
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
        head("Elo", "games", "truth", "H1 accepted", "seeds, mean", "theory", "of theory", "range held");
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
                for (double elo1 : new double[] {10, 50}) {
                    sprt(model, 0, elo1, at, false, 0);
                    sprt(model, 0, elo1, -at, false, 0);
                }
                sprt(model, at - 50, at, at - 50, false, 0);
                sprt(model, at - 50, at, at, false, 0);
            }
            sprt(model, 0, 10, 0, true, 30);
            sprt(model, 0, 10, 10, true, 30);
        }
        PublishedTable.write("rating.md", "sprt", lines);
    }

    @Test
    @Tag("campaign")
    void adaptivePairingNeedsFewerGames() throws IOException {
        head("steps between neighbours, Elo", "round robin, seeds", "adaptive, seeds", "share", "order true",
            "strengths known");
        long whole = Math.max(2, LEAGUES / 200);
        StopRule rule = new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL);
        double[] even = new double[15];
        Arrays.fill(even, 35);
        for (double[] each : new double[][] {{10, 60, 20, 50, 30, 40, 15, 55, 25, 45, 35, 60, 20, 50, 30},
            {60, 57, 53, 50, 46, 43, 39, 36, 32, 29, 25, 22, 18, 14, 10}, drawn(1), drawn(2), drawn(3), even}) {
            MadeUpLeague league = MadeUpLeague.sixteen(each);
            double turns = PlayedLeagues.scheduled(league, whole, false, rule, MOST).mean(0);
            PlayedLeagues learnt = PlayedLeagues.scheduled(league, whole, true, rule, MOST);
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
        Ratings ratings = new Ratings(List.of(0, 1, 2), RatingFit.of(3, league.groups().stream()
            .map(group -> group.inProportion(1 << 20)).toList(), false));
        double[] parts = ratings.parts(List.of(new int[] {0, 1})).values().stream().mapToDouble(part -> part).toArray();
        double roots = Arrays.stream(parts).map(Math::sqrt).sum();
        assertEquals(roots * roots / (3 * Arrays.stream(parts).sum()), BestAllocation.share(league), 1e-3);
    }
}
