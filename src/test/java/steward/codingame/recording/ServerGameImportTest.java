package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.TestSize;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Recordings of a game with views of its own, played here and by the server: they verify, and changes are found. */
@Execution(ExecutionMode.CONCURRENT)
class ServerGameImportTest {

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

    /** The lines of a key frame from the first score on, changed one at a time. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1 | 7 | turn 20, view line 1, word 0: recorded 7",
        "4 | 299 | turn 20, view line 4, word 0: recorded 299"})
    @Tag("slow")
    void aChangedNumberOfAPlayerIsFound(int line, String to, String expected) {
        assertTrue(difference(20, line, to).toString().startsWith(expected), expected);
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void aChangedPlaceIsFound() {
        int each = TestSize.of(100, 13);
        for (int turn = 1; turn <= GAME.turns(); turn += each) {
            String[] lines = view(turn).split("\n");
            int line = Arrays.asList(lines).lastIndexOf("#1.00000");
            while (!lines[line].startsWith("1 ")) {
                line++;
            }
            String[] words = lines[line].split(" ");
            words[1] = Long.toString(Long.parseLong(words[1]) + 1);
            ReplayDifference found = difference(turn, line, String.join(" ", words));
            assertNotNull(found, "turn " + turn);
            assertEquals(turn, found.turn());
            assertEquals("view line " + line + ", word 1", found.field());
        }
    }

    @Test
    @Tag("slow")
    void aChangedTimeAPlaceAndASpeedOfAnImpactAreFound() {
        int turn = 1;
        while (!view(turn).split("\n")[16].matches("#0\\.[1-8].*")) {
            turn++;
        }
        String[] lines = view(turn).split("\n");
        String time = lines[16].substring(0, 7) + (lines[16].endsWith("1") ? "2" : "1");
        assertEquals("view line 16, word 0", difference(turn, 16, time).field());
        String[] words = lines[17].split(" ");
        for (int k = 0; k < 5; k++) {
            String[] changed = words.clone();
            changed[k] = Long.toString(Long.parseLong(changed[k]) - 1);
            assertEquals("view line 17, word " + k, difference(turn, 17, String.join(" ", changed)).field());
        }
    }

    @Test
    void anImpactThatTheServerHasNotIsFound() {
        int turn = 1;
        while (!view(turn).split("\n")[16].startsWith("#0")) {
            turn++;
        }
        String view = view(turn);
        int from = view.indexOf("#0");
        String without = view.substring(0, from) + view.substring(view.indexOf('#', from + 1));
        String difference = difference(turn, without).toString();
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

    private static ReplayDifference difference(int turn, int line, String to) {
        String[] lines = view(turn).split("\n");
        lines[line] = to;
        return difference(turn, String.join("\n", lines));
    }

    private static ReplayDifference difference(int turn, String view) {
        ObjectNode changed = GAME.gameResult();
        ImportedRecording.frame(changed, 3 * turn).put("view", view);
        return ImportedRecording.verified(changed).difference();
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

    @Test
    void aFrameThatIsMissingAndAFileThatIsCutAreTold() {
        ObjectNode missing = SHORT.gameResult();
        ((ArrayNode) missing.get("frames")).remove(4);
        String gap = ImportedRecording.problem(missing.toString());
        assertTrue(gap.startsWith(
            "game.json: frame 4, view line 0: found \" 5\", expected the number of the frame, 4: frames are missing"),
            gap);
        String json = SHORT.json();
        String problem = ImportedRecording.problem(json.substring(0, json.length() / 2));
        assertTrue(problem.contains("within the JSON") && problem.contains("expected all of it"), problem);
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
