package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Search races in the form of the site's JSON, played here: their ends, and what the views must hold. */
class SearchRaceImportTest {

    private final ObjectNode game = ServerGame.searchRace();
    private final ArrayNode frames = (ArrayNode) game.get("frames");
    private final ViewComparison views = new ViewComparison();

    private Verification verified() {
        return ImportedRecording.of(game.toString()).verified(views);
    }

    private void declare(String time) {
        game.putArray("ranks").add(0);
        game.putArray("scores").add(1.0);
        String end = "{\"entitymodule\":\"\",\"endScreen\":[[" + time.split("\\.")[0] + "],\"image\",[\"" + time
            + "\"]]}";
        frames.addObject().put("agentId", 0).put("keyframe", true).put("view", " " + (frames.size() - 1) + "\n" + end);
    }

    private String time() {
        return ImportedRecording.of(game.toString()).text().replaceFirst("(?s).*\"score\":([0-9.]+).*", "$1");
    }

    private void spoil(int frame, String from, String to) {
        ObjectNode node = ImportedRecording.frame(game, frame);
        node.put("view", ImportedRecording.replaced(node.get("view").asString(), from, to));
    }

    @Test
    void aRaceToTheFinishVerifiesWithItsTime() {
        int turns = frames.size() - 1;
        declare(time());
        Verification found = verified();
        assertNull(found.difference());
        assertTrue(found.verified());
        assertEquals(turns, found.turns());
        assertTrue(views.values() > 20 * turns, "views are compared");
    }

    @Test
    void anotherTimeOfTheFinishIsFound() {
        String time = time();
        declare(time.substring(0, time.length() - 1) + (time.endsWith("5") ? '6' : '5'));
        assertEquals("view line 1, word 2", verified().difference().field());
    }

    @Test
    void anAnswerThatCannotBeReadLosesTheRace() {
        ImportedRecording.cut(game, 8);
        game.putArray("ranks").add(0);
        ObjectNode last = ImportedRecording.frame(game, 7);
        last.put("stdout", "left\n").put("summary", "Can't parse").put("view",
            " 7\n{\"entitymodule\":\"\",\"debug\":[],\"endScreen\":[[1000],\"image\",[\"1000.0\"]]}\n");
        assertNull(verified().difference());
        spoil(7, "\"1000.0\"", "\"1000.5\"");
        assertTrue(verified().difference().toString().contains("1000.5"));
    }

    @Test
    void updatesInAnotherOrderAreTheSame() {
        for (int k = 1; k < frames.size(); k++) {
            String view = frames.get(k).get("view").asString();
            String updates = view.replaceFirst("(?s).*\"U([^\"]*)\".*", "$1");
            StringBuilder turned = new StringBuilder();
            for (String update : updates.split(";")) {
                turned.insert(0, turned.isEmpty() ? update : update + ";");
            }
            spoil(k, updates, turned + ";99 1 v 1 x 3 \u0393 y 4 \u0393 z 3");
        }
        assertNull(verified().difference());
    }

    @Test
    void aViewThatIsNoJsonIsFound() {
        spoil(3, "{", "<");
        assertEquals("turn 3, view line 1", verified().difference().toString().substring(0, 19));
    }

    @Test
    void aGameOfTheSameToolkitIsNamedByItsView() {
        ImportedRecording.frame(game, 0).put("view", " 0\n{\"global\":{},\"frame\":{\"entitymodule\":\"CS\"}}\n");
        String problem = ImportedRecording.problem(game.toString());
        assertTrue(problem.matches("game.json: frame 0, view line 1: found \"\\{.global.*expected the name of a game "
            + "that is known: CodersStrikeBack, Search Race.*"), problem);
    }
}
