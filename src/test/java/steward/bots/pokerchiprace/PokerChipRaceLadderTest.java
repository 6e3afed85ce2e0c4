package steward.bots.pokerchiprace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.Bot;
import steward.match.MatchResult;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.replay.Recorded;

/** The bundled bots: without faults, the better one better, and answers that need no memory. */
@Execution(ExecutionMode.CONCURRENT)
class PokerChipRaceLadderTest {

    /** In 400 games, other seeds, the better one won more than nine in ten. */
    @Test
    @Tag("slow")
    @Tag("sized")
    @Tag("campaign")
    void theBetterOneWins() {
        int games = TestSize.of(4, 24);
        int won = 0;
        for (int game = 0; game < games; game++) {
            List<Bot> bots = game % 2 == 0 ? List.of(PokerChipRaceBots.glutton(), PokerChipRaceBots.nibbler())
                : List.of(PokerChipRaceBots.nibbler(), PokerChipRaceBots.glutton());
            MatchResult result = Recorded.of(TestScenes.open("poker-chip-race"), game / 2, bots).result();
            assertFalse(result.anyFault(), result.toString());
            won += result.winner() == game % 2 ? 1 : 0;
        }
        assertTrue(won >= games * 3 / 4, "won " + won + " of " + games);
    }

    /** A debugger that is fed the frames from some turn on sees the same bot. */
    @Test
    @Tag("slow")
    void anAnswerFollowsFromTheSetupAndTheTurnAlone() {
        List<String> lines = new ArrayList<>();
        Recorded.of(TestScenes.open("poker-chip-race"), 2,
            List.of(PokerChipRaceBots.glutton(lines::add), PokerChipRaceBots.nibbler()));
        assertTrue(lines.size() > 6, "lines: " + lines.size());
        for (int k = 1; k + 1 < lines.size() - 1; k += 2) {
            ChipBot fresh = new Glutton();
            fresh.answer(lines.get(0));
            assertEquals(lines.get(k + 1), fresh.answer(lines.get(k)));
        }
    }

    @Test
    void anotherGameIsRefused() {
        assertThrows(IllegalArgumentException.class,
            () -> new Nibbler().answer("{\"type\":\"setup\",\"game\":\"pod-race\"}"));
    }
}
