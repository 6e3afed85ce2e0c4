package steward.lab.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.pairing.StopRule;
import steward.league.rating.RatingFit;
import steward.league.rating.Ratings;
import steward.league.rating.Stratum;
import steward.league.sequential.Gsprt;
import steward.match.TestSize;

/** A small form of {@code steward league --self-check}: fixed seeds, bounds of four standard deviations. */
@Execution(ExecutionMode.CONCURRENT)
class SelfCheckTest {

    private static final int LEAGUES = 1000;
    private static final double FOUR_DEVIATIONS = fourDeviations(LEAGUES);
    private static final double PROMISED = 0.007;

    /** Of a share of 95% of so many leagues. */
    private static double fourDeviations(long leagues) {
        return 4 * Math.sqrt(0.95 * 0.05 / leagues);
    }

    private static void holds(MadeUpLeague league, int clusters) throws InterruptedException {
        Coverage found = FixedCheck.even(league, clusters).run(2, LEAGUES, 5).bars();
        assertEquals(0.95, found.least(), PROMISED + FOUR_DEVIATIONS, found::toString);
        assertEquals(0.95, found.most(), PROMISED + FOUR_DEVIATIONS, found::toString);
    }

    @Test
    @Tag("slow")
    void fixedBarsHold() throws InterruptedException {
        holds(MadeUpLeague.pairs("two", new double[] {100, 0}, 0, 0, 0, 0), 60);
        holds(MadeUpLeague.pairs("ties and seeds", new double[] {60, 0}, 0.5, 50, 150, 0), 40);
        holds(MadeUpLeague.pairs("trio", MadeUpLeague.spaced(4, 30), 0.1, 0, 60, 150), 30);
        holds(MadeUpLeague.threes("threes", 60, MadeUpLeague.spaced(4, 60)), 30);
        holds(MadeUpLeague.alone("alone", MadeUpLeague.spaced(4, 60)), 60);
    }

    private static void holds(ScheduleCheck.Outcome found, Coverage.Among among, long leagues) {
        Coverage bars = found.ofFixed(among);
        assertEquals(0.95, bars.least(), PROMISED + fourDeviations(leagues), bars::toString);
        assertEquals(0.95, bars.most(), PROMISED + fourDeviations(leagues), bars::toString);
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void fixedBarsHoldHoweverBotsArePaired() throws InterruptedException {
        long leagues = TestSize.of(50, LEAGUES);
        holds(new ScheduleCheck(MadeUpLeagues.trio(), true, StopRule.NONE, 100).run(2, leagues, 5),
            Coverage.Among.ALL, leagues);
        holds(new ScheduleCheck(MadeUpLeagues.mixed(), true, StopRule.NONE, 900).run(2, leagues, 5),
            Coverage.Among.ALL, leagues);
        ScheduleCheck.Outcome gauntlet = new ScheduleCheck(MadeUpLeagues.mixed().gauntlet(3), false, StopRule.NONE,
            200).run(2, leagues, 5);
        assertEquals(40, gauntlet.rarest(), 1e-9);
        holds(gauntlet, Coverage.Among.WITH_HERO, leagues);
        holds(gauntlet, Coverage.Among.OTHERS, leagues);
    }

    @Test
    void aGauntletTellsNothingOfPairsThatHaveNotMet() throws InterruptedException {
        // Rock is played by scissors, which lose 150 Elo, and paper, which wins them: scissors seem 300 Elo below paper
        // and are in truth above.
        MadeUpLeague trio = MadeUpLeagues.trio();
        ScheduleCheck played = new ScheduleCheck(trio.gauntlet(0).comparedWith(trio.truth()), false, StopRule.NONE,
            200);
        assertEquals(0, played.run(2, 50, 5).ofFixed(Coverage.Among.OTHERS).most());
    }

    @Test
    void whatNoBarCanDoIsComputed() {
        // Binomial chances of 60 games, summed up by a program of a few lines of Python: the range of scores with a
        // chance nearest to 95% has 94.12% at 440 Elo and 96.20% at 445.
        ExactCheck.Outcome best = new OtherBars(60).best(300, 515);
        assertEquals(0.9412327816503685, best.least(), 1e-12);
        assertEquals(0.9620295697011976, best.most(), 1e-12);
        ExactCheck.Outcome wilson = new OtherBars(60).wilson(300, 515);
        ExactCheck.Outcome midP = new OtherBars(60).midP(300, 515);
        ExactCheck.Outcome ours = new ExactCheck(30).run(300, 515);
        assertTrue(ours.least() > wilson.least() && ours.least() > midP.least(), wilson + " " + midP);
        assertTrue(ours.most() < wilson.most() && ours.most() < midP.most(), wilson + " " + midP);
    }

    @Test
    void theBestAllocationHasItsClosedForm() {
        // Of three bots the last is far away: only the first two are in doubt, whose variance is c1/n1 + c2/n2 + c3/n3.
        // The least sum of n for it is (sqrt(c1) + sqrt(c2) + sqrt(c3))^2, that of equal n is 3 (c1 + c2 + c3).
        MadeUpLeague league = MadeUpLeague.pairs("three", new double[] {10, 0, -600}, 0, 0, 0, 0);
        List<Stratum> strata = league.groups().stream().map(group -> group.inProportion(1 << 20)).toList();
        Ratings ratings = new Ratings(List.of(0, 1, 2), RatingFit.of(3, strata, false), 1, 0, 0);
        double roots = 0;
        double sum = 0;
        for (double part : ratings.parts(List.of(new int[] {0, 1})).values()) {
            roots += Math.sqrt(part);
            sum += part;
        }
        assertEquals(roots * roots / (3 * sum), new BestAllocation(league).share(), 1e-3);
        assertEquals(1, new BestAllocation(MadeUpLeague.pairs("two", new double[] {10, 0}, 0, 0, 0, 0)).share(), 1e-6);
    }

    @Test
    void barsHoldWhereSeedsMatterMuch() throws InterruptedException {
        // With seeds of 300 Elo the two games of a seed go alike so often that a seed's mean varies by a quarter more
        // than that of two independent games: bars of independent games would be too short.
        MadeUpLeague league = MadeUpLeague.pairs("seeds", new double[] {0, 0}, 0, 0, 300, 0);
        Coverage right = FixedCheck.even(league, 100).run(2, LEAGUES, 5).bars();
        MadeUpGroup independent = MadeUpGroup.two(0, 0, 0, 0, 0, 1);
        assertTrue(league.groups().get(0).variance() > 1.25 * independent.variance(), "seeds matter");
        assertEquals(0.95, right.least(), PROMISED + FOUR_DEVIATIONS, right::toString);
    }

    @Test
    @Tag("slow")
    void barsOfTwoBotsHoldForAllStrengthsAsFarAsWholeGamesLetThem() throws InterruptedException {
        // Of 60 games one more or less has a chance of up to 3% where the bar ends: no bar can do better than about so.
        ExactCheck.Outcome near = new ExactCheck(30).run(0, 300);
        ExactCheck.Outcome far = new ExactCheck(30).run(300, 515);
        assertTrue(near.least() > 0.942 && far.least() > 0.936, near + " " + far);
        // Where bars of two sides and bounds meet, both miss at once: computed, and told in docs/rating.md.
        assertTrue(new ExactCheck(30).run(515, 800).least() > 0.929);
        assertTrue(new ExactCheck(30).run(800, 1300).least() > 0.99);
        assertEquals(0.95, near.mean(), 0.002);
        assertTrue(far.most() < 0.975, far::toString);
        ExactCheck.Outcome many = new ExactCheck(200).run(0, 515);
        assertEquals(0.95, many.least(), PROMISED);
        assertEquals(0.95, many.most(), 0.009, many::toString);
        // Played, it is what was computed.
        MadeUpLeague league = MadeUpLeague.pairs("two", new double[] {400, 0}, 0, 0, 0, 0);
        assertEquals(new ExactCheck(30).run(400, 401).mean(),
            FixedCheck.even(league, 30).run(2, LEAGUES, 5).bars().least(), FOUR_DEVIATIONS);
    }

    @Test
    void rangesOfRanksHaveTheTrueRank() throws InterruptedException {
        // Where three are equal, each has all ranks; a range that leaves one out is wrong.
        MadeUpLeague even = MadeUpLeague.pairs("even", MadeUpLeague.spaced(3, 0), 0.1, 0, 0, 0);
        double found = FixedCheck.even(even, 40).run(2, LEAGUES, 5).ranks();
        assertTrue(found >= 0.95 - FOUR_DEVIATIONS && found < 1, found + "");
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void anytimeBarsHoldAtAllLooks() throws InterruptedException {
        for (MadeUpLeague league : List.of(
            MadeUpLeague.pairs("two", new double[] {480, 0}, 0, 0, 0, 0),
            MadeUpLeague.pairs("trio", MadeUpLeague.spaced(3, 0), 0.1, 0, 60, 150),
            MadeUpLeague.alone("alone", MadeUpLeague.spaced(3, 60)))) {
            Coverage found = new AnytimeCheck(league, 150).run(2, TestSize.of(125, LEAGUES / 2), 5);
            assertTrue(found.least() >= 0.95, found::toString);
        }
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void leaguesThatAreEndedByARuleAreRight() throws InterruptedException {
        MadeUpLeague league = MadeUpLeague.pairs("six", new double[] {200, 120, 90, 0, -60, -200}, 0.3, 20, 50, 40);
        StopRule rule = new StopRule(Double.NaN, true, 20);
        int leagues = TestSize.of(20, 40);
        ScheduleCheck.Outcome turns = new ScheduleCheck(league, false, rule, 100_000).run(2, leagues, 5);
        ScheduleCheck.Outcome learnt = new ScheduleCheck(league, true, rule, 100_000).run(2, leagues, 5);
        assertTrue(turns.right() >= 0.95 && learnt.right() >= 0.95, turns + " " + learnt);
        assertTrue(learnt.atLooks(Coverage.Among.ALL).least() >= 0.85, learnt::toString);
        assertTrue(learnt.decisions() < 0.8 * turns.decisions(), turns + " " + learnt);
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void sequentialTestsErrAsRarelyAsTheySay() throws InterruptedException {
        long runs = TestSize.of(200, LEAGUES);
        for (Gsprt.Model model : Gsprt.Model.values()) {
            Gsprt test = new Gsprt(0, 40, 0.05, 0.05, model);
            for (double at : new double[] {0, 40}) {
                SprtCheck.Outcome found = new SprtCheck(test, at, 0.5, 100, 0).run(2, runs, 5);
                double wrong = at == 0 ? found.accepted() : 1 - found.accepted();
                assertTrue(wrong <= 0.05 + fourDeviations(runs), found::toString);
                assertEquals(1, found.mean() / found.theory().observations(), 0.1, found::toString);
                assertTrue(found.held() >= 0.95, found::toString);
            }
        }
    }

    @Test
    @Tag("campaign")
    void sequentialTestsErrAsRarelyFarApartAndWhereTheFirstSeedsAreAlike() throws InterruptedException {
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double elo : new double[] {200, 500}) {
                Gsprt far = new Gsprt(elo - 50, elo, 0.05, 0.05, model);
                assertErrs(new SprtCheck(far, elo - 50, 0, 0, 0), 0.05, true);
                assertErrs(new SprtCheck(far, elo, 0, 0, 0), 0.05, false);
            }
            Gsprt near = new Gsprt(0, 10, 0.05, 0.05, model);
            for (double elo : new double[] {200, 500, 1000}) {
                assertErrs(new SprtCheck(near, -elo, 0, 0, 0), 0, true);
                assertErrs(new SprtCheck(near, elo, 0, 0, 0), 0, false);
            }
            assertErrs(new SprtCheck(near, 0, 1, 100, 30), 0.05, true);
            assertErrs(new SprtCheck(near, 10, 1, 100, 30), 0.05, false);
        }
    }

    /** @param never true if H1 is wrong */
    private static void assertErrs(SprtCheck check, double atMost, boolean never) throws InterruptedException {
        SprtCheck.Outcome found = check.run(2, LEAGUES, 5);
        double wrong = never ? found.accepted() : 1 - found.accepted();
        assertTrue(wrong <= atMost + (atMost > 0 ? FOUR_DEVIATIONS : 0), () -> check + ": " + found);
        assertEquals(1, found.mean() / found.theory().observations(), 0.1, () -> check + ": " + found);
        assertTrue(found.held() >= 0.95, () -> check + ": " + found);
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void threadsDoNotChangeTheTable() throws InterruptedException {
        List<String> one = new ArrayList<>();
        for (String part : TestSize.isWhole() ? List.of("fixed", "pairings") : List.of("pairings")) {
            List<String> other = new ArrayList<>();
            one.clear();
            new SelfCheck(TestSize.of(4, 10), 1, one::add).print(part);
            new SelfCheck(TestSize.of(4, 10), 3, other::add).print(part);
            assertEquals(one, other);
            assertTrue(one.size() >= 50, "it has its rows");
        }
        String row = "gauntlet of bot 4: others | 1500 | 300.0";
        assertTrue(one.stream().anyMatch(line -> line.contains(row)), row);
    }
}
