package steward.lab.capacity;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import steward.bot.InProcessPlayer;
import steward.cli.shared.Games;
import steward.lab.capacity.LeagueCosts.Part;
import steward.lab.capacity.MeasuredLeague.Kind;
import steward.lab.capacity.MeasuredLeague.Sample;
import steward.lab.cli.bench.BenchDirectBot;
import steward.lab.cli.bench.BenchLineBot;
import steward.match.Seat;

/** Measurements are there: games are played by the worker, through the broker, checked and stored. */
@Tag("process")
@Tag("slow")
@Isolated("counts the time of all threads of a kind")
@Timeout(120)
class MeasuredLeagueTest {

    @TempDir
    private Path folder;

    private static MeasuredBots bots() {
        return new MeasuredBots(Games.types(), Games.open("mad-pod-racing"),
            (entrant, isolation, others) -> Seat.direct(entrant.name(), new BenchDirectBot()).player(),
            (entrant, isolation, others) -> new InProcessPlayer(entrant.name(), new BenchLineBot()),
            number -> "builtin:regular 3 0." + number);
    }

    /** A league, measured until it has ended games, which takes longer on a busy machine. */
    private Sample measured(boolean served, double seconds) throws Exception {
        Sample found = new MeasuredLeague(bots(), folder).measure(served, new MeasuredLeague.Effort(20, seconds, 1, 2));
        return found.perSecond() > 0 || seconds > 100 ? found : measured(served, 5 * seconds);
    }

    @Test
    void aLeagueIsMeasured() throws Exception {
        Sample alone = measured(false, 0.2);
        assertTrue(alone.perSecond() > 0 && alone.perSecond() < 60, alone::toString);
        assertTrue(alone.kinds().get(Kind.GAMES) > 0, alone::toString);
    }

    /** So short that the schedule and the connections may take less than the clock of the threads can tell. */
    @Test
    @Tag("campaign")
    void aServedLeagueIsMeasured() throws Exception {
        Sample served = measured(true, 0.2);
        assertTrue(served.perSecond() > 0 && served.perSecond() < 60, served::toString);
        assertTrue(served.kinds().get(Kind.GAMES) > 0 && served.kinds().get(Kind.WORKER_GAMES) > 0, served::toString);
        CheckPrices prices = CheckPrices.measure(bots(), 0.1);
        assertTrue(prices.again() > prices.check(), "whoever asks bots again plays the game again first: " + prices);
        assertTrue(Capacity.costs(served, prices).total() > prices.check(), prices::toString);
    }

    @Test
    @Tag("campaign")
    void eachKindOfThreadHasItsShare() throws Exception {
        MeasuredLeague league = new MeasuredLeague(bots(), folder);
        MeasuredLeague.Effort effort = new MeasuredLeague.Effort(20, 2, 2, 2);
        Sample alone = league.measure(false, effort);
        Sample served = league.measure(true, effort);
        assertTrue(alone.perSecond() > 0 && alone.perSecond() < 30, () -> "no more than it is told: " + alone);
        assertTrue(served.perSecond() > 0 && served.perSecond() < 30, served::toString);
        for (Kind kind : new Kind[] {Kind.BROKER, Kind.MESSAGES, Kind.WORKER_BROKER, Kind.WORKER_GAMES,
                Kind.SCHEDULE}) {
            // the JVM's common pool counts as the broker's, and a broker of another test may still be closing
            assertTrue(alone.kinds().get(kind) < served.kinds().get(kind) / 4, () -> kind + ": " + alone + served);
        }
        for (Sample each : new Sample[] {alone, served}) {
            assertTrue(each.kinds().get(Kind.GAMES) > 0 && each.kinds().get(Kind.STORE) > 0, each::toString);
            assertTrue(each.threads() > 0 && each.process() > 0, each::toString);
        }
        CheckPrices prices = CheckPrices.measure(bots(), 0.1);
        assertTrue(prices.again() > prices.check(), "whoever asks bots again plays the game again first: " + prices);
        LeagueCosts costs = Capacity.costs(served, prices);
        assertTrue(costs.total() > prices.check() && costs.most(Part.PROCESSORS, 2) > 0, costs::toString);
    }
}
