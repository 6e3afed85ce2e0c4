package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.bot.Bot;
import steward.bot.TestBots;
import steward.match.TestScenes;
import steward.replay.verify.ReplayDifference;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Words of the site for people, in forms that public battles of 2026 show. */
class InformationImportTest {

    private static final int FAILS = 33;

    private static final List<String> COMMANDS = List.of("\"boost\":true", "\"boost\":true", "\"shield\":true",
        "\"thrust\":70", "\"thrust\":70", "\"thrust\":70", "\"thrust\":70");

    /** Boosts twice, raises its shield and goes on. */
    private static Bot scripted() {
        return TestBots.byTurn(turn -> {
            String pod = "{\"x\":8000,\"y\":4500," + COMMANDS.get(Math.min(turn, COMMANDS.size()) - 1) + "}";
            return "{\"pods\":[" + pod + "," + pod + "]}";
        });
    }

    private static final List<String> TOLD = List.of("boosts towards (8000, 4500)",
        "moves towards (8000, 4500) at power 200", "enabled its shield", "waits for its engine to reload",
        "waits for its engine to reload", "waits for its engine to reload", "moves towards (8000, 4500) at power 70");

    private static ObjectNode told() {
        ObjectNode game = OfficialGame.play(TestScenes.open("mad-pod-racing"), 3, scripted(), scripted())
            .gameResult();
        for (int turn = 1; turn <= TOLD.size(); turn++) {
            for (int player = 0; player < 2; player++) {
                String pod = " of player $" + player + " " + TOLD.get(turn - 1) + "\n";
                ImportedRecording.frame(game, 2 * turn - 1 + player).put("gameInformation",
                    "Pod 1" + pod + "Pod 2" + pod);
            }
        }
        return game;
    }

    @Test
    void theFourFormsOfWhatAPodDoesAreCompared() {
        assertNull(ImportedRecording.verified(told()).difference());
        for (int turn = 1; turn <= TOLD.size(); turn++) {
            ObjectNode game = told();
            ObjectNode frame = ImportedRecording.frame(game, 2 * turn);
            frame.put("gameInformation", frame.get("gameInformation").stringValue().replace("Pod 2 of player $1 ",
                "Pod 2 of player $1 never "));
            ReplayDifference found = ImportedRecording.verified(game).difference();
            assertEquals(turn + " gameInformation line 1, word 5", found.turn() + " " + found.field());
        }
    }

    @Test
    void theTooltipOfATimeoutIsThatOfThePlayersFrame() {
        OfficialGame game = OfficialGame.play(3);
        for (int frame : new int[] {2 * FAILS, 2 * FAILS - 1}) {
            ObjectNode sketch = (ObjectNode) JsonMapper.shared().readTree(game.sketch(FAILS));
            sketch.putArray("tooltips").add("{\"turn\":" + frame
                + ",\"text\":\"$1: timeout!\",\"event\":1}");
            ReplayDifference found = ImportedRecording.verified(sketch).difference();
            assertEquals(frame == 2 * FAILS ? "null" : FAILS + " tooltips line 0", found == null ? "null"
                : found.turn() + " " + found.field());
        }
    }
}
