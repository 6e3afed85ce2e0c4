package steward.replay.verify;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import steward.game.Game;
import steward.json.JsonObject;
import steward.replay.JsonLine;
import steward.replay.ReplayLines;
import steward.replay.ReplayReader;
import tools.jackson.core.JsonGenerator;

/** Parts of recorded lines beside the same parts as this version writes them. */
final class RecordedJson {

    private static void raw(JsonGenerator out, String name, byte[] json) {
        out.writeName(name);
        out.writeRawValue(new String(json, StandardCharsets.UTF_8));
    }

    /** Compares the bytes; only where they differ, both are parsed. */
    static ReplayDifference compare(int turn, byte[] recorded, byte[] found) {
        return Arrays.equals(recorded, found) ? null : ReplayDifference.between(turn, recorded, found);
    }

    /** Compares drawing and start. */
    static ReplayDifference compareOpening(ReplayReader replay, Resimulation again) {
        byte[] recorded = JsonObject.of(out -> {
            raw(out, "drawing", replay.drawing());
            raw(out, "start", replay.start());
        });
        return compare(0, recorded, JsonObject.of(out -> ReplayLines.writeOpening(out, again.game(), again.codec())));
    }

    /** Compares what the result says of every player's place. */
    static ReplayDifference compareStanding(ReplayReader replay, Game game) {
        return compare(game.turn(), JsonObject.of(out -> raw(out, "standing", replay.result().array("standing"))),
            JsonObject.of(out -> ReplayLines.writeStanding(out, game)));
    }

    /** Compares the hash of everything before the field, which also covers what has no effect on the game. */
    static ReplayDifference compareHash(int turn, String field, JsonLine line) {
        String recorded = line.text(field);
        String found = line.hashBefore(field);
        return recorded.equals(found) ? null
            : new ReplayDifference(turn, field, recorded, found + " of the line as it stands");
    }
}
