package steward.replay.verify;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.Consumer;
import steward.game.Game;
import steward.json.JsonNumbers;
import steward.replay.JsonLine;
import steward.replay.ReplayLines;
import steward.replay.ReplayReader;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/** Parts of recorded lines beside the same parts as they are written today. */
final class RecordedJson {

    /** One object. */
    static byte[] object(Consumer<JsonGenerator> fields) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(4096);
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            out.writeStartObject();
            fields.accept(out);
            out.writeEndObject();
        }
        return bytes.toByteArray();
    }

    private static void raw(JsonGenerator out, String name, byte[] json) {
        out.writeName(name);
        out.writeRawValue(new String(json, StandardCharsets.UTF_8));
    }

    /** Compares the bytes; only where they differ, both are parsed. */
    static Difference compare(int turn, byte[] recorded, byte[] found, boolean observed) {
        if (Arrays.equals(recorded, found)) {
            return null;
        }
        return observed ? Difference.fromObserved(turn, recorded, found) : Difference.between(turn, recorded, found);
    }

    /** Compares drawing and start. */
    static Difference compareOpening(ReplayReader replay, Resimulation again) {
        byte[] recorded = object(out -> {
            raw(out, "drawing", replay.drawing());
            raw(out, "start", replay.start());
        });
        boolean shown = replay.imported() && again.serverView() != null;
        byte[] found = object(out -> {
            if (shown) {
                ReplayLines.writeShownOpening(out, again.codec(), state ->
                    again.serverView().writeShownStart(state, again.game(), again.codec().state()));
            } else {
                ReplayLines.writeOpening(out, again.game(), again.codec());
            }
        });
        return compare(0, recorded, found, replay.imported());
    }

    /** Compares what the result says of every player's place. */
    static Difference compareStanding(ReplayReader replay, Game game) {
        byte[] recorded = object(out -> raw(out, "standing", replay.result().array("standing")));
        byte[] found = object(out -> ReplayLines.writeStanding(out, game));
        return compare(game.turn(), recorded, found, replay.imported());
    }

    /** Compares the hash of everything before the field, which also covers what has no effect on the game. */
    static Difference compareHash(int turn, String field, JsonLine line) {
        String recorded = line.text(field);
        String found = line.hashBefore(field);
        return recorded.equals(found) ? null
            : new Difference(turn, field, recorded, found + " of the line as it stands");
    }
}
