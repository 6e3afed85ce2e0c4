package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.ChangedWords;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Recordings of a game with views of its own, played here and by the server: they verify, and changes are found. */
@Execution(ExecutionMode.CONCURRENT)
class ServerGameImportTest {

    private static final Pattern WORD = Pattern.compile("\\S+");
    private static final ServerMeanMax GAME = ServerMeanMax.play(5, 300);
    private static final ServerMeanMax SHORT = ServerMeanMax.play(5, 3);

    @Test
    @Tag("slow")
    void aWholeGameVerifiesInAllThatIsShown() {
        Verification found = ImportedRecording.verified(GAME.json());
        assertNull(found.difference());
        assertTrue(found.verified());
        assertEquals(GAME.turns(), found.states());
        assertTrue(GAME.impacts() > 100 && GAME.sunk() > 3, "there is something to compare");
    }

    @Test
    void aGameThatEndsEarlyIsImportedAsFarAsItGoes() {
        ImportedRecording recording = ImportedRecording.of(SHORT.json());
        assertEquals(new RecordingImport.Imported(3, null), recording.imported());
        Verification found = recording.verified();
        assertTrue(found.agrees());
        assertEquals(3, found.turns());
    }

    /** All words of a turn with impacts but the number of its frame, and some of later turns, changed a little. */
    @Test
    @Tag("slow")
    void aChangedWordIsFoundWhereItIs() {
        int first = turnWithImpact("#0\\.[1-8].*");
        for (int turn : new int[] {first, 20, 150}) {
            ObjectNode game = GAME.gameResult();
            game.remove(List.of("scores", "ranks"));
            ImportedRecording.cut(game, 3 * turn + 1);
            List<ChangedWords> changes = ChangedWords.of(view(turn), WORD, ServerGameImportTest::next);
            for (int k = 1; k < changes.size(); k += turn == first ? 1 : 13) {
                ChangedWords change = changes.get(k);
                ImportedRecording.frame(game, 3 * turn).put("view", change.text());
                ReplayDifference found = ImportedRecording.verified(game).difference();
                assertNotNull(found, change::toString);
                assertEquals(turn, found.turn(), change::toString);
                assertEquals("view line " + change.line() + ", word " + change.word(), found.field());
            }
        }
    }

    /** A number with another last digit, which is a word too, or a word with one more letter. */
    private static String next(String word) {
        char last = word.charAt(word.length() - 1);
        return Character.isDigit(last) ? word.substring(0, word.length() - 1) + (last - '0' + 1) % 10 : word + "x";
    }

    private static int turnWithImpact(String line) {
        int turn = 1;
        while (!view(turn).split("\n")[16].matches(line)) {
            turn++;
        }
        return turn;
    }

    @Test
    void anImpactThatTheServerHasNotIsFound() {
        int turn = turnWithImpact("#0.*");
        String view = view(turn);
        int from = view.indexOf("#0");
        String without = view.substring(0, from) + view.substring(view.indexOf('#', from + 1));
        ObjectNode changed = GAME.gameResult();
        ImportedRecording.frame(changed, 3 * turn).put("view", without);
        String difference = ImportedRecording.verified(changed).difference().toString();
        assertTrue(difference.startsWith("turn " + turn + ", view line 16"), difference);
    }

    @Test
    @Tag("slow")
    void aChangedResultIsFound() {
        ObjectNode changed = GAME.gameResult();
        ((ArrayNode) changed.get("scores")).set(1, 1000.0);
        assertEquals("scores line 0, word 1", ImportedRecording.verified(changed).difference().field());
        changed = GAME.gameResult();
        ArrayNode ranks = (ArrayNode) changed.get("ranks");
        int first = ranks.get(0).intValue();
        ranks.set(0, ranks.get(2).intValue()).set(2, first);
        assertTrue(ImportedRecording.verified(changed).difference().field().startsWith("ranks line 0"));
    }

    @Test
    void aPlayerThatSaidNothingFailsThere() {
        ObjectNode silent = SHORT.gameResult();
        ImportedRecording.frame(silent, 5).remove("stdout");
        assertTrue(ImportedRecording.of(silent.toString()).text().contains(
            "\"faults\":[null,\"no answer in the recording\",null]"));
    }

    private static String view(int turn) {
        return GAME.gameResult().get("frames").get(3 * turn).get("view").stringValue();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "meanmax | FantasticBits | frame 0, view line 1: found \"FantasticBits\", expected the name of a game that is "
            + "known: CodersStrikeBack, Search Race, meanmax, Fantastic Bits",
        "seed=5\\n | sneed=5 | refereeInput: found \"sneed=5\", expected a line seed=NUMBER",
        "\"refereeInput\" | \"other\" | refereeInput: found nothing, expected a line seed=NUMBER",
        "\" 4\\n\" | \" 5\\n\" | frame 4, view line 0: found \" 5\", expected the number of the frame, 4: frames are "
            + "missing",
        "\"agentId\":2 | \"agentId\":1 | frame 3, agentId: found 1, expected a player behind 1, or a key frame before",
        "\"agentId\":2 | \"agentId\":-1 | frame 3, agentId: found -1, expected the number of the player whose answer",
        "\"agentId\":2 | \"agentId\":3 | found answers of 4 players, expected 3 of mean-max",
        "\"agentId\":2 | \"agentId\":\"2\" | frame 3, agentId: found \"2\", expected the number of a player "
            + "0..7, or -1",
        "\"keyframe\":true,\"agentId\":2 | \"keyframe\":1,\"agentId\":2 | frame 3, keyframe: found 1, expected true",
        "\"stdout\":\"0 0 300 | \"stdout\":5,\"b\":\"0 0 300 | frame 1, stdout: found 5, expected a text"})
    void whatIsWrongIsToldWithItsFrameAndLine(String from, String to, String expected) {
        String problem = ImportedRecording.problem(SHORT.json(), from, to);
        assertTrue(problem.startsWith("game.json: " + expected), problem);
    }

    /** Lines of the start that the server would not have shown. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "meanmax\\n3\\n | meanmax\\n2\\n | view line 2, word 0",
        "#1.00000 | #0.99999 | view line 21, word 0",
        "#1.00000\\n0 | #1.00000\\n0 1 x | view line 22, word 1",
        "#1.00000\\n0 | #1.00000\\n77@3\\n0 | view line 22, word 0",
        "#1.00000\\n0 | #1.00000\\n77 d\\n0 | view line 22, word 0",
        "\\n#1.00000 | \\n#0.5\\n#1.00000 | view line 21, word 0",
        "\\n3\\n0\\n | \\n3\\n-1\\n | view line 6, word 0"})
    void otherLinesOfTheStartAreFound(String from, String to, String field) {
        ReplayDifference found = ImportedRecording.verified(ImportedRecording.replaced(SHORT.json(), from, to))
            .difference();
        assertEquals(0, found.turn());
        assertEquals(field, found.field());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "[0,1] | ranks: found \"[0,1]\", expected an array of 3",
        "[0,1,1] | ranks[2]: found 1, expected the number of a player 0..2, each once",
        "[0,1,3] | ranks[2]: found 3, expected the number of a player 0..2, each once"})
    void ranksThatAreNone(String ranks, String expected) {
        String json = SHORT.gameResult().put("x", 0).toString().replace("\"x\":0", "\"ranks\":" + ranks);
        assertEquals("game.json: " + expected, ImportedRecording.problem(json).split(": the numbers")[0]);
    }
}
