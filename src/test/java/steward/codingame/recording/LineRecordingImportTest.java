package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.TextCodec;
import steward.match.TestScenes;
import steward.replay.Recorded;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Games for one player that are known by their lines: played here, and held as a recording would be. */
class LineRecordingImportTest {

    private final List<String> sent = new ArrayList<>();
    private final List<String> answers = new ArrayList<>();

    /** So many turns of a search race in which the car circles. */
    private void play(int turns) {
        GameSetup setup = TestScenes.open("search-race");
        Game game = setup.create(3);
        TextCodec codec = setup.textCodec(game).orElseThrow();
        StringBuilder out = new StringBuilder();
        codec.writeSetup(out, 0);
        for (int turn = 0; turn < turns && !game.isOver(); turn++) {
            codec.writeTurn(out, 0);
            String answer = turn < 600 ? "EXPERT " + turn % 10 + " 150" : "";
            answers.add(answer);
            assertNull(codec.readAnswer(0, answer.getBytes(StandardCharsets.UTF_8), answer.length()));
            game.play();
        }
        sent.addAll(out.toString().lines().toList());
    }

    private String json() {
        ObjectNode recording = JsonMapper.shared().createObjectNode();
        sent.forEach(recording.putArray("stdin")::add);
        answers.forEach(recording.putArray("stdout")::add);
        return recording.toString();
    }

    private void assertImported(int turns, String ending) {
        assertEquals(new RecordingImport.Imported(turns, ending), ImportedRecording.of(json()).imported());
    }

    private void assertDifferent(String message) {
        assertEquals("game.json: " + message,
            assertThrows(DifferentGameException.class, () -> ImportedRecording.of(json())).getMessage());
    }

    @Test
    void aWholeGameBecomesAReplayThatVerifies() {
        play(1000);
        assertImported(600, "lost: not finished in 600 turns");
        assertEquals(Recorded.whole(600), ImportedRecording.verified(json()));
    }

    @Test
    void aRecordingThatEndsEarlyIsImportedAsFarAsItGoes() {
        play(20);
        assertImported(20, null);
    }

    /** The map has eight checkpoints: a line with the number, 24 places, then a line a turn. */
    @Test
    void theFirstLineThatDiffersIsNamed() {
        play(20);
        String ours = sent.set(25 + 7, "0 1 2 3 4 5");
        assertDifferent("stdin[32], turn 8: found \"0 1 2 3 4 5\", by these rules \"" + ours + "\"");
    }

    /** The car did not answer in the last turn: what it was sent there is compared, and there can be no more. */
    @Test
    void linesBehindTheLastAnswerAreCompared() {
        play(20);
        answers.remove(19);
        assertImported(19, null);
        String ours = sent.set(25 + 19, "0 1 2 3 4 5");
        assertDifferent("stdin[44], turn 20: found \"0 1 2 3 4 5\", by these rules \"" + ours + "\"");
        sent.set(25 + 19, ours);
        answers.remove(18);
        assertDifferent("stdin[44]: found \"" + ours + "\", expected the end: turn 19 has no answer");
    }

    @Test
    void linesOfNoKnownGameAreRefused() {
        sent.addAll(List.of("3", "1 2", "3 4"));
        answers.add("1 2 3");
        assertEquals("game.json: stdin: found lines of no game for one player that is known, expected those that such "
            + "a game is sent at its beginning", ImportedRecording.problem(json()));
        answers.clear();
        assertEquals("game.json: stdout: found no lines, expected an array of them",
            ImportedRecording.problem(json()));
    }
}
