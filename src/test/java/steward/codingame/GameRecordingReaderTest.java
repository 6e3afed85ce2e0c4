package steward.codingame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.TestScenes;
import steward.scene.json.SceneException;

/** Recordings that cannot be used: the error says in which frame and line, what was found and what was expected. */
class GameRecordingReaderTest {

    private static final String PODS = pods();
    private static final String START = "KEY_FRAME 0\\na\\nb\\n1000 1000 9000 1000 5000 5000\\nc\\n" + PODS;
    /** A game of one turn. */
    private static final String GAME = "{\"frames\":[{\"view\":\"" + START + "\",\"keyframe\":true},"
        + "{\"stdout\":\"1 2 3\\n1 2 3\\n\",\"keyframe\":false},"
        + "{\"stdout\":\"1 2 3\\n1 2 3\\n\",\"keyframe\":true,\"view\":\"KEY_FRAME 2\\n" + PODS
        + "0:100\\n1:99\\n0 0.25 3 1 2 1 5 6 240.5 1 -2\\n\"}],\"ranks\":[0,1]}";

    private static String pods() {
        StringBuilder lines = new StringBuilder();
        for (int pod = 0; pod < 4; pod++) {
            lines.append(1000 + pod).append(" 2000 -0 4 100 0 5 6 ").append(pod == 0 ? "null" : "-1.5").append(" 1 ")
                .append(2).append(" 0\\n\\\"message \\\"\\n");
        }
        return lines.toString();
    }

    private static String problemOf(String json) {
        return assertThrows(IllegalArgumentException.class, () -> GameRecordingReader.read(json, "game.json"))
            .getMessage();
    }

    @Test
    void allThatIsThereIsRead() {
        GameRecording game = GameRecordingReader.read(GAME, "game.json");
        assertEquals(3, game.checkpoints().length);
        assertEquals(5000, game.checkpoints()[2][1]);
        assertEquals(new GameRecording.Pod(1000, 2000, 0.0, 4, Double.NaN, true, 2), game.start().get(0));
        assertEquals(new GameRecording.Pod(1003, 2000, 0.0, 4, -1.5, true, 2), game.start().get(3));
        assertEquals(List.of(0, 1), game.ranks());
        GameRecording.Turn turn = game.turns().get(0);
        assertEquals(1, game.turns().size());
        assertEquals(2, turn.frame());
        assertEquals(List.of("1 2 3", "1 2 3"), turn.commands().get(1));
        assertEquals(game.start(), turn.after());
        assertEquals(List.of(new GameRecording.Impact(0.25, 3, 1, 240.5)), turn.impacts());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "1000 1000 9000 | 1000 1000 | frame 0, view line 3: found \"1000 1000 1000 5000 5000\", "
            + "expected x y of two or more checkpoints",
        "9000 1000 5000 | 9000 NaN 5000 | frame 0, view line 3: found \"NaN\", expected a finite number",
        "\\nc\\n1000 2000 | \\nc\\n1000 y | frame 0, view line 5: found \"y\", expected a finite number",
        "2\\n1000 2000 | 2\\n1000 2000 \\n | frame 2, view line 1: found \"1000 2000 \", expected pod 0: x y",
        "0:100 | x y z | frame 2, view line 9: found \"x y z\", expected an impact: id",
        "0 0.25 3 | 0 soon 3 | frame 2, view line 11: found \"soon\", expected a finite number",
        "0.25 3 1 | 0.25 4 1 | frame 2, view line 11: found \"4\", expected a whole number 0..3",
        "5 6 240.5 1 -2 | 5 6 | frame 2, view line 11: found \"0 0.25 3 1 2 1 5 6\", expected an",
        "false},{\"stdout\" | true},{\"stdout\" | frame 1, keyframe: found true, expected false, because player 1",
        "\"keyframe\":true, | \"keyframe\":false, | frame 2, keyframe: found false, expected true, because both",
        "\"keyframe\":false | \"keyframe\":\"no\" | frame 1, keyframe: found \"no\", expected true or false",
        "false},{\"stdout\":\"1 2 3\\n1 2 3\\n\" | false},{\"stdout\":5 | frame 2, stdout: found 5, expected a text",
        "true,\"view\":       | true,\"view\":[1],\"v\": | frame 2, view: found [1], expected a text",
        "\"ranks\":[0,1] | \"ranks\":[\"a\",1] | ranks: found \"[\"a\",1]\", expected an array of 2 whole numbers",
        "\"ranks\":[0,1] | \"ranks\":[0] | ranks: found \"[0]\", expected an array of 2 whole numbers",
        "\"ranks\":[0,1] | \"ranks\":[0,2] | ranks: found \"[0,2]\", expected an array of 2 whole numbers 0..1",
        "1 2 0\\n\\\"message \\\"\\n0:100 | 1 3 0\\n\\\"message \\\"\\n0:100 | frame 2, view line 7: found \"3\", "
            + "expected a whole number 0..2",
        "0.25 3 1 | 0x1p-2 3 1 | frame 2, view line 11: found \"0x1p-2\", expected a finite number",
        "9000 1000 5000 | 9000d 1000 5000 | frame 0, view line 3: found \"9000d\", expected a finite number",
        "{\"stdout\":\"1 2 3\\n1 2 3\\n\",\"keyframe\":false} | 5 | frame 1: found 5, expected an object",
        "\"frames\" | \"frame\" | found no frames, expected CodinGame's game result with an array",
        "\"ranks\":[0,1]}     | \"ranks\":[0,1]       | 1:"})
    void whatIsWrongIsToldWithItsFrameAndLine(String from, String to, String expected) {
        String json = GAME.replace(from, to);
        assertTrue(GAME.contains(from), "there is no " + from);
        String problem = problemOf(json);
        assertTrue(problem.startsWith("game.json: " + expected) || problem.startsWith("game.json:" + expected),
            problem);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "[]", "5", "null", "{}", "{\"success\":null}", "{\"frames\":[]}", "{\"frames\":{}}",
        "{\"success\":{\"gameResult\":{\"frames\":5}}}", "{\"frames\":[5]}", "{\"frames\":[{\"view\":\"a\\nb\\nc\"}]}",
        "{\"frames\":[null]}", "not JSON"})
    void whatIsNoRecordingAtAll(String json) {
        assertTrue(problemOf(json).startsWith("game.json:"), problemOf(json));
    }

    @Test
    void aMapThatCannotBeRacedOnIsRefused() {
        String json = GAME.replace("1000 1000 9000 1000", "9000 1000 9000 1000");
        String problem = assertThrows(SceneException.class,
            () -> GameRecordingImport.of(json, "game.json", TestScenes.TYPES)).getMessage();
        assertTrue(problem.startsWith("game.json (scene):") && problem.contains("the first two in the same place"),
            problem);
    }
}
