package steward.lab.capacity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.lab.capacity.CapacitySimulation.Load;
import steward.lab.capacity.CapacitySimulation.Setting;
import steward.lab.capacity.LeagueCosts.Part;
import steward.lab.capacity.SaturationTable.Row;
import steward.match.TestSize;

/** The simulation against what is known of queues without it. */
@Execution(ExecutionMode.CONCURRENT)
class CapacitySimulationTest {

    private static final long SEED = 5;

    /** Only one part takes time. */
    private static LeagueCosts only(double check) {
        return new LeagueCosts(0, 0, check, 0, 0, 0, 0);
    }

    /**
     * Very many workers, each with few games, are a stream of Poisson, and one processor with a fixed time s for each
     * is the queue M/D/1: a result is in the process for s + rho s / (2 (1 - rho)) on average, by the formula of
     * Pollaczek and Khinchine. With N workers the stream is thinner by the share that waits, below 0.1% here. Waits of
     * games that follow each other are alike over some 1 / (1 - rho)^2 games, so the mean of n games has a standard
     * error of about sqrt(2 / n) / (1 - rho): 1.1% of 400,000 at rho = 0.8, 0.9% of 100,000 at rho = 0.5.
     */
    @Test
    @Tag("slow")
    void manyWorkersAndOneProcessorAreTheQueueMD1() {
        assertQueueMD1(2000, 100_000, 0.5);
    }

    @Test
    @Tag("campaign")
    void veryManyWorkersAndOneProcessorAreTheQueueMD1AtAnyLoad() {
        assertQueueMD1(20_000, 400_000, 0.2, 0.5, 0.8);
    }

    private static void assertQueueMD1(int workers, int games, double... loads) {
        double micros = 1000;
        for (double rho : loads) {
            double perSecond = rho * 1e6 / micros;
            Load load = CapacitySimulation.of(only(micros),
                new Setting(1, workers, workers / perSecond * 1e9, 2 * workers), games, SEED);
            double expected = (micros + rho * micros / (2 * (1 - rho))) / 1e3;
            assertEquals(expected, load.delayMs(), 0.04 * expected, () -> "seed " + SEED + ", rho " + rho);
            assertEquals(rho, load.processors(), 0.01, () -> "seed " + SEED);
            // Little's law: those inside are the rate times their time inside, whatever the distributions.
            assertEquals(load.stored() * load.delayMs() / 1e3, load.inside(), 0.001 * load.inside());
        }
    }

    /** Nothing waits, and so nothing is late, where there are as many processors as games. */
    @Test
    void whereNothingWaitsAGameTakesAsLongAsItsSteps() {
        LeagueCosts costs = new LeagueCosts(300, 50, 400, 0, 0, 70, 90);
        Load load = CapacitySimulation.of(costs, new Setting(1000, 1, 1e9, 1), 2000, SEED);
        assertEquals((300 / 2.0 + 50 + 400) / 1e3, load.delayMs(), 1e-9);
    }

    /** The bounds of closed queueing networks: no part does more than it has time for, the busiest does just that. */
    @Test
    @Tag("slow")
    @Tag("sized")
    void whenSaturatedThePartThatIsBusiestDecidesHowManyGamesThereAre() {
        LeagueCosts costs = new LeagueCosts(300, 100, 400, 2000, 0.05, 50, 200);
        assertEquals(1150, costs.total(), 1e-9);
        for (int processors : TestSize.isWhole() ? new int[] {1, 2, 4} : new int[] {2}) {
            Load load = CapacitySimulation.of(costs, new Setting(processors, 500, 10e6, 2500), 40_000, SEED);
            assertEquals(processors / 1150e-6, load.perSecond(), 0.01 * load.perSecond());
            assertEquals(load.perSecond(), load.stored(), 0.02 * load.stored());
            assertEquals(1, load.processors(), 0.01);
            assertEquals(Part.PROCESSORS, costs.first(processors));
        }
        Load load = CapacitySimulation.of(costs, new Setting(32, 500, 10e6, 2500), 40_000, SEED);
        assertEquals(1 / 200e-6, load.stored(), 0.01 * load.stored(), "the thread that stores: 200 us a game");
        assertEquals(1, load.store(), 0.01);
        assertEquals(5000 * 50e-6, load.schedule(), 0.01, "no game begins before there is room to store another");
        assertEquals(Part.STORE, costs.first(32));
        assertEquals(5000, costs.most(Part.STORE, 32), 1e-9);
    }

    /** Work half done before counting begins must not make more games than there is time for. */
    @Test
    @Tag("sized")
    void whatIsSimulatedStaysWithinItsBound() {
        LeagueCosts costs = new LeagueCosts(1100, 70, 650, 0, 0, 420, 280);
        for (int workers : TestSize.isWhole() ? new int[] {50, 200, 1000} : new int[] {200}) {
            Row row = Row.of(costs, 2, workers, 20, 2500);
            double most = costs.most(Part.PROCESSORS, 2);
            assertEquals(most, row.load().perSecond(), 0.002 * most, () -> workers + " workers");
        }
    }

    /**
     * A queue of games that wait to be stored does not raise the count: as long as it grows, games begin faster than
     * they end.
     */
    @Test
    @Tag("slow")
    @Tag("sized")
    void aQueueThatStillGrowsIsNotCounted() {
        LeagueCosts costs = new LeagueCosts(190, 22, 405, 3616, 0.05, 37, 67);
        for (int processors : TestSize.isWhole() ? new int[] {16, 32} : new int[] {32}) {
            Row row = Row.of(costs, processors, 1000, 20, 2500);
            double most = costs.most(Part.STORE, processors);
            assertEquals(most, row.load().perSecond(), 0.004 * most, () -> processors + " processors");
            assertEquals(most, row.load().stored(), 0.004 * most, () -> processors + " processors");
        }
    }

    /** No more games are played than workers have time for, nor than may be under way. */
    @Test
    @Tag("slow")
    void workersAndPlacesAreBoundsToo() {
        LeagueCosts costs = new LeagueCosts(1, 1, 1, 1, 0, 1, 1);
        Load load = CapacitySimulation.of(costs, new Setting(4, 10, 1e9, 2500), 40_000, SEED);
        assertEquals(10, load.stored(), 0.03 * 10);
        assertEquals(load.stored(), load.perSecond(), 0.001 * 10);
        assertEquals(1, load.workers(), 0.01);
        load = CapacitySimulation.of(costs, new Setting(4, 1000, 1e9, 200), 40_000, SEED);
        assertEquals(200, load.perSecond(), 0.03 * 200, "200 places, a second for each game");
        assertEquals(0.2, load.workers(), 0.01);
    }

    @Test
    @Tag("slow")
    void theSameArgumentsGiveTheSameResult() {
        LeagueCosts costs = new LeagueCosts(300, 100, 400, 2000, 0.05, 50, 200);
        Setting setting = new Setting(2, 20, 50e6, 2500);
        assertEquals(CapacitySimulation.of(costs, setting, 5000, SEED),
            CapacitySimulation.of(costs, setting, 5000, SEED));
    }

    @Test
    void rowsAreForOneTwoFiveAndSoOn() {
        assertEquals(List.of(1, 2, 5, 10, 20, 50, 100, 200, 500, 1000), SaturationTable.counts(1000));
        assertEquals(List.of(1, 2, 5, 7), SaturationTable.counts(7));
        assertEquals(List.of(1), SaturationTable.counts(1));
    }

    @Test
    @Tag("slow")
    void theSentenceNamesThePartOfTheFigures() {
        LeagueCosts costs = new LeagueCosts(300, 100, 400, 2000, 0.05, 50, 700);
        Row row = Row.of(costs, 2, 20, 200, 2500);
        SaturationTable table = new SaturationTable(costs, 2, List.of(row), row,
            List.of(Row.of(costs, 32, 20, 200, 2500)));
        List<String> lines = CapacityText.simulation(table);
        assertTrue(lines.contains("First to have no time left: the processors, at 1,212 games/s, which are 7 workers "
            + "that play 200 games/s each."), lines::toString);          // 2 / 1650 us
        assertTrue(lines.stream().anyMatch(line -> line.matches(
            "\\| 32 \\| 1,4[0-9]{2} \\| the thread that stores \\|")), lines::toString);      // 1 / 700 us = 1,429
    }
}
