package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.AlteredBot;
import steward.codingame.recording.OfficialGame;
import steward.codingame.recording.RecordingImport;
import steward.game.GameSetup;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** Real traffic: every frame, every answer and every line of the replay of whole matches is valid. */
@Execution(ExecutionMode.CONCURRENT)
class TrafficTest {

    private static final Schema REPLAY = Schemas.open("replay");

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "walled-race", "duel"})
    @Tag("slow")
    void wholeMatchesOfTheShippedScenes(String scene) {
        check(TestScenes.open(scene), 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "walled-race"})
    @Tag("slow")
    void aCrowdOfThreeInWhichOneFails(String scene) {
        check(TestScenes.changed(scene, "\"players\": 2", "\"players\": 3"), 12);
    }

    /** Matches that another referee played and we keep: whole, and with all the parts missing that may be missing. */
    @Test
    void importedMatches() throws InterruptedException {
        OfficialGame game = OfficialGame.play(12);
        for (String recording : List.of(game.json(), game.sketch(20))) {
            ByteArrayOutputStream replay = new ByteArrayOutputStream();
            RecordingImport.of(recording, "game.json", TestScenes.TYPES, null).write(replay);
            List<String> lines = replay.toString(StandardCharsets.UTF_8).lines().toList();
            assertTrue(lines.size() > 20 && lines.get(0).contains("\"server\":["));
            for (String line : lines) {
                assertEquals(List.of(), Schemas.problems(REPLAY, line), line);
            }
        }
    }

    /** @param bad the turn in which the first bot says something unusable; 0 for none */
    private static void check(GameSetup setup, int bad) {
        List<String> lines = new ArrayList<>();
        List<AlteredBot> bots = new ArrayList<>();
        for (int player = 0; player < setup.scene().players(); player++) {
            int fails = player == 0 ? bad : 0;
            bots.add(new AlteredBot(new SeededBot(player, 0.4), (turn, answer) -> {
                lines.add(answer);
                return turn == fails ? "thrust!" : answer;
            }));
        }
        Recorded match = Recorded.of(setup, 9, List.copyOf(bots));

        for (int player = 0; player < bots.size(); player++) {
            List<String> sent = bots.get(player).sent();
            boolean wasAskedToTheEnd = match.result().players().get(player).out() == null;
            assertTrue(!wasAskedToTheEnd || sent.size() == match.result().turns() + 2, "frames seen: " + sent.size());
            lines.addAll(sent);
        }
        for (String line : lines) {
            assertEquals(List.of(), Schemas.problems(GameSchemasTest.schemaOf(Schemas.POD_RACE, line), line), line);
        }
        for (String line : match.lines()) {
            assertEquals(List.of(), Schemas.problems(REPLAY, line), line);
        }
        assertEquals(bad > 0, match.text().contains("\"faults\""));
        assertTrue(match.text().contains("\"impacts\"") && match.text().contains("\"messages\""));
    }
}
