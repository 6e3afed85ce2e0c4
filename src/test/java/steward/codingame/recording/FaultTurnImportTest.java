package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import steward.bot.Bot;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.verify.ReplayDifference;
import tools.jackson.databind.node.ObjectNode;

/** The last turn of a pod race that a fault has ended: the server plays it and shows it, so it is compared. */
class FaultTurnImportTest {

    /** Behind the line of number, the lines of four pods with their messages, and the counters. */
    private static final int FIRST_IMPACT = 10;
    private static final int IMPULSE = 8;

    private final OfficialGame game = IntStream.range(5, 200).mapToObj(FaultTurnImportTest::endsByAFault)
        .filter(each -> each.impactTurns().contains(each.turns())).findFirst().orElseThrow();

    private static OfficialGame endsByAFault(int turn) {
        return OfficialGame.play(TestScenes.open("mad-pod-racing"), 5, new SeededBot(5, 0.6), new Failing(turn));
    }

    /** Rams, and in one turn says what cannot be read. */
    private static final class Failing implements Bot {

        private final Bot rams = new SeededBot(6, 0.6);
        private final int turn;
        private int turns;

        Failing(int turn) {
            this.turn = turn;
        }

        @Override
        public void setup(String line) {
            rams.setup(line);
        }

        @Override
        public String turn(String line) {
            return ++turns == turn ? "left" : rams.turn(line);
        }
    }

    private ReplayDifference changed(int line, int word, String to) {
        return ImportedRecording.verified(ImportedRecording.changeView(game.gameResult(),
            OfficialGame.keyFrame(game.turns()), lines -> {
                String[] words = lines.get(line).split(" ");
                words[word] = to.replace("#", words[word]);
                lines.set(line, String.join(" ", words));
            })).difference();
    }

    @Test
    void asItIsItVerifies() {
        assertNull(ImportedRecording.verified(game.json()).difference());
    }

    /** Word behind the number, and messages of the player who fails: public battles of 2026 show none. */
    @Test
    void aWordOrAMessageThatBattlesDoNotShowIsFound() {
        assertEquals("view line 0, word 1", changed(0, 1, "# endReached").field());
        assertEquals("view line 6, word 0", changed(6, 0, "\"bye\"").field());
    }

    @Test
    void impulsePlaceAndMissingImpactsAreFound() {
        ObjectNode without = ImportedRecording.changeView(game.gameResult(), OfficialGame.keyFrame(game.turns()),
            lines -> lines.subList(FIRST_IMPACT, lines.size()).clear());
        for (ReplayDifference found : new ReplayDifference[] {changed(FIRST_IMPACT, IMPULSE, "1234.5"),
            changed(1, 0, "77"), changed(3, 1, "78"), ImportedRecording.verified(without).difference()}) {
            assertNotNull(found);
            assertEquals(game.turns(), found.turn(), found.toString());
        }
        assertTrue(game.turns() < 200, "a fault has ended it");
    }
}
