package steward.bots.searchrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.bot.Bot;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** The bundled bots of the search race finish; the one that plans ahead takes less time; replays verify. */
class SearchRaceBotsTest {

    private static double time(Bot bot, long seed) {
        Recorded match = Recorded.of(TestScenes.open("search-race"), seed, List.of(bot));
        assertEquals(Recorded.whole(match.result().turns()), match.verify());
        assertEquals("finished after 3 laps", match.result().ending(), "seed " + seed);
        return match.result().players().get(0).score();
    }

    @Test
    @Tag("slow")
    void thePlainBotFinishesEveryOfficialMap() {
        for (long seed = 0; seed < 50; seed++) {
            assertTrue(time(SearchRaceBots.driver(), seed) < 600);
        }
    }

    @Test
    @Tag("slow")
    void theBetterBotIsQuickerOnEveryTenthMap() {
        for (long seed = 0; seed < 50; seed += 10) {
            double plain = time(SearchRaceBots.driver(), seed);
            double better = time(SearchRaceBots.planner(), seed);
            assertTrue(better < plain, "seed " + seed + ": " + better + " and " + plain);
        }
    }

    @Test
    void aSetupOfAnotherGameIsRefused() {
        assertEquals("this bot plays search-race, not pod-race", assertThrows(IllegalArgumentException.class,
            () -> new Driver().answer("{\"type\":\"setup\",\"game\":\"pod-race\"}")).getMessage());
    }
}
