package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import steward.codingame.recording.RecordingImport.Imported;
import steward.game.podrace.RulesEdition;
import steward.match.TestScenes;
import steward.replay.ReplayReader;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * A recording in the site's JSON, imported as {@code game.json}, and what tests change in one before.
 *
 * @param imported how far it went
 * @param replay   that was made of it
 */
record ImportedRecording(Imported imported, byte[] replay) {

    static ImportedRecording of(String json) {
        return of(json, null);
    }

    /** @param rules {@code null} where none are named */
    static ImportedRecording of(String json, RulesEdition rules) {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        try {
            Imported imported = RecordingImport.of(json, "game.json", TestScenes.TYPES, rules).write(replay);
            return new ImportedRecording(imported, replay.toByteArray());
        } catch (InterruptedException nobodyDoes) {
            throw new AssertionError(nobodyDoes);
        }
    }

    static Verification verified(String json) {
        return of(json).verified();
    }

    static Verification verified(JsonNode game) {
        return verified(game.toString());
    }

    /** Message of the refusal of a recording that cannot be used. */
    static String problem(String json) {
        return assertThrows(IllegalArgumentException.class, () -> of(json)).getMessage();
    }

    /** Message of the refusal of a text in which the first such part is another. */
    static String problem(String json, String from, String to) {
        return problem(replaced(json, from, to));
    }

    /** A text in which the first such part, which must be there, is another. */
    static String replaced(String json, String from, String to) {
        int at = json.indexOf(from);
        if (at < 0) {
            throw new IllegalArgumentException("there is no " + from);
        }
        return json.substring(0, at) + to + json.substring(at + from.length());
    }

    static ObjectNode frame(ObjectNode game, int number) {
        return (ObjectNode) game.get("frames").get(number);
    }

    /** Removes all frames behind so many. */
    static void cut(ObjectNode game, int frames) {
        ArrayNode all = (ArrayNode) game.get("frames");
        while (all.size() > frames) {
            all.remove(all.size() - 1);
        }
    }

    /** Changes the lines of a frame's view. @return the game */
    static ObjectNode changeView(ObjectNode game, int frame, Consumer<List<String>> change) {
        ObjectNode of = frame(game, frame);
        List<String> lines = new ArrayList<>(of.get("view").stringValue().lines().toList());
        change.accept(lines);
        of.put("view", String.join("\n", lines) + "\n");
        return game;
    }

    Verification verified() {
        return verified(new ViewComparison());
    }

    /** @param views counts what is compared */
    Verification verified(ViewComparison views) {
        return Verification.of(new ReplayReader(new ByteArrayInputStream(replay), "r.jsonl"), TestScenes.TYPES, views);
    }

    /** The first difference or missing turn of a verification, or {@code null}. */
    String difference(Verification found) {
        return found.difference() != null ? found.difference().toString()
            : imported.turns() == found.turns() ? null : found.turns() + " turns verified of " + imported.turns();
    }

    String text() {
        return new String(replay, StandardCharsets.UTF_8);
    }
}
