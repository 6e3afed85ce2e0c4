package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.scene.json.SceneException;

/** Recordings that cannot be used: the error says in which frame and line, what was found and what was expected. */
class GameRecordingReaderTest {

    private static final String PODS = pods();
    private static final String START = " 0\\nCodersStrikeBack\\n16000 9000 400 600 4 0.3\\n"
        + "1000 1000 9000 1000 5000 5000\\n0 1 2 0 1 2 1 1 2 1 1 2\\n" + PODS + "1:100 1:100\\n";
    /** A game of one turn. */
    private static final String GAME = "{\"frames\":[{\"view\":\"" + START + "\",\"keyframe\":true},"
        + "{\"stdout\":\"1 2 3\\n1 2 3\\n\",\"keyframe\":false},"
        + "{\"stdout\":\"1 2 3\\n1 2 3\\n\",\"keyframe\":true,\"view\":\" 2\\n" + PODS
        + "1:98 2:99\\n0 0.25 3 1 2 1 5 6 240.5 1 -2\\n\"}],\"ranks\":[0,1]}";

    private static String pods() {
        StringBuilder lines = new StringBuilder();
        for (int pod = 0; pod < 4; pod++) {
            lines.append(1000 + pod).append(" 2000 -0 4 100 0 5 6 ").append(pod == 0 ? "null" : "-1.5").append(" 1 ")
                .append(2).append(" 0\\n\\\"message \\\"\\n");
        }
        return lines.toString();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "1000 1000 9000 | 1000 1000 | frame 0, view line 3: found \"1000 1000 1000 5000 5000\", "
            + "expected x y of two or more checkpoints",
        "9000 1000 5000 | 9000 NaN 5000 | frame 0, view line 3: found \"NaN\", expected a finite number",
        "\" 2\\n | \" 4\\n | frame 2, view line 0: found \" 4\", expected the number of the frame, "
            + "2: frames are missing",
        "\"keyframe\":false | \"keyframe\":false,\"view\":\" 3\\n\" | frame 1, view line 0: found \" 3\", expected the",
        "\" 2\\n | \"view\\n | frame 2, view line 0: found \"view\", expected the number of the frame, 2",
        "400 600 4 | 400 600 2 | frame 0, view line 2: found \"16000 9000 400 600 2 0.3\", expected 4 pods",
        "\"keyframe\":true, | \"keyframe\":false, | frame 2, keyframe: found false, expected true",
        "\"keyframe\":false | \"keyframe\":\"no\" | frame 1, keyframe: found \"no\", expected true or false",
        "\"keyframe\":true} | \"keyframe\":2} | frame 0, keyframe: found 2, expected true or false",
        "\"keyframe\":true} | \"keyframe\":true,\"agentId\":\"x\"} | frame 0, agentId: found \"x\", expected the",
        "false},{\"stdout\":\"1 2 3\\n1 2 3\\n\" | false},{\"stdout\":5 | frame 2, stdout: found 5, expected a text",
        "true,\"view\":       | true,\"view\":[1],\"v\": | frame 2, view: found [1], expected a text",
        "\"ranks\":[0,1] | \"ranks\":[\"a\",1] | ranks: found \"[\"a\",1]\", expected an array of 2: the numbers",
        "\"ranks\":[0,1] | \"ranks\":[0] | ranks: found \"[0]\", expected an array of 2: the numbers",
        "\"ranks\":[0,1] | \"ranks\":[0,2] | ranks[1]: found 2, expected the number of a player 0..1, each once",
        "9000 1000 5000 | 9000d 1000 5000 | frame 0, view line 3: found \"9000d\", expected a finite number",
        "{\"stdout\":\"1 2 3\\n1 2 3\\n\",\"keyframe\":false} | 5 | frame 1: found 5, expected an object",
        "\"frames\" | \"frame\" | found no frames: the object has frame, ranks, expected CodinGame's game result",
        "\"keyframe\":false | \"keyframe\":false,\"agentId\":-1 | frame 1, agentId: found -1, expected the number",
        "\"keyframe\":false | \"keyframe\":false,\"agentId\":1 | frame 1, keyframe: found false, expected true",
        "\"ranks\":[0,1]}     | \"ranks\":[0,1]       | 1:"})
    void whatIsWrongIsToldWithItsFrameAndLine(String from, String to, String expected) {
        assertProblem(expected, ImportedRecording.problem(GAME, from, to));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "[]", "5", "null", "{}", "{\"success\":null}", "{\"frames\":[]}", "{\"frames\":{}}",
        "{\"success\":{\"gameResult\":{\"frames\":5}}}", "{\"frames\":[5]}", "{\"frames\":[{\"view\":\"a\\nb\\nc\"}]}",
        "{\"frames\":[null]}", "not JSON"})
    void whatIsNoRecordingAtAll(String json) {
        assertTrue(ImportedRecording.problem(json).startsWith("game.json:"), ImportedRecording.problem(json));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "` \\n` | found an empty file, expected CodinGame's game result with an array \"frames\"",
        "{\"type\":\"steward-replay\",\"format\":2,\"game\":1} | found a replay of Steward, expected CodinGame's",
        "{\"errors\":{},\"outputs\":{},\"views\":[],\"uinput\":[]} | found the game result that "
            + "'steward referee -l' writes",
        "`{\"a\":1}\\n{\"b\":2}\\n` | found JSON Lines, one value a line, expected CodinGame's",
        "{\"frames\":[{\"view\":\" 0 | 1:23: found the end of the file within the JSON: it was cut "
            + "off, expected all of it",
        "`Replay between Neumann and pb4GOD\\nROUND` | found a text file, not JSON: it begins with \"Replay between "
            + "Neumann and pb4GOD\", expected CodinGame's",
        "`S 34 4072 4725 -102 76 -0.5585049757212007 0 2` | found a text file, not JSON: it begins with \"S 34 4072 "
            + "4725 -102 76 -0.55850497572...\", expected",
        "<!DOCTYPE html> | found a web page or XML, expected CodinGame's",
        "[1,2] | found no frames: the file is an array, expected CodinGame's",
        "{\"id\":403,\"message\":\"no\"} | found no frames: the object has id, message, expected CodinGame's"})
    void anotherFileIsToldByWhatItIs(String text, String expected) {
        assertProblem(expected, ImportedRecording.problem(text.replace("\\n", "\n")));
    }

    private static void assertProblem(String expected, String problem) {
        assertTrue(problem.startsWith("game.json: " + expected) || problem.startsWith("game.json:" + expected),
            problem);
    }

    @Test
    void aMapThatCannotBeRacedOnIsRefused() {
        String json = GAME.replace("1000 1000 9000 1000", "9000 1000 9000 1000");
        String problem = assertThrows(SceneException.class,
            () -> ImportedRecording.of(json)).getMessage();
        assertTrue(problem.startsWith("game.json (scene):") && problem.contains("the first two in the same place"),
            problem);
    }
}
