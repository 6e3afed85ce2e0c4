package steward.replay;

import java.util.List;
import java.util.Locale;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.JsonNumbers;
import steward.game.TurnEvent;
import steward.numerics.StateHash;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.core.JsonGenerator;

/**
 * Writes what follows from the commands: impacts, paths, events, the ending by the impact limit, the state and its
 * hash. What is empty is left out. The writer records it, the verifier writes it again and compares.
 */
final class OutcomeJson {

    /** A turn can have over ten thousand impacts; the first so many of them are kept, and so many corners of paths. */
    private static final int MOST = 2000;

    private OutcomeJson() {
    }

    /** One object: the outcome of the turn just played. */
    static void write(JsonGenerator out, Game game, FrameCodec codec) {
        out.writeStartObject();
        TurnLog log = game.log();
        writeImpacts(out, log);
        writePaths(out, game, log);
        writeEvents(out, game.events());
        if (log.limited()) {
            out.writeObjectPropertyStart("impactLimit");
            JsonNumbers.write(out, "time", log.limitTime());
            out.writeArrayPropertyStart("bodies");
            for (int id : log.limitBodies()) {
                out.writeNumber(id);
            }
            out.writeEndArray();
            out.writeEndObject();
        }
        writeState(out, game, codec);
        out.writeEndObject();
    }

    /** The fields {@code state} and {@code hash}. */
    static void writeState(JsonGenerator out, Game game, FrameCodec codec) {
        out.writeObjectPropertyStart("state");
        codec.writeState(out);
        out.writeEndObject();
        out.writeStringProperty("hash", StateHash.toHex(game.hash()));
    }

    private static void writeImpacts(JsonGenerator out, TurnLog log) {
        if (log.impacts() == 0) {
            return;
        }
        out.writeArrayPropertyStart("impacts");
        for (int k = 0; k < Math.min(MOST, log.impacts()); k++) {
            Impact impact = log.impact(k);
            out.writeStartObject();
            JsonNumbers.write(out, "time", impact.time());
            out.writeNumberProperty("a", impact.a());
            if (impact.isWall()) {
                out.writeNumberProperty("wall", impact.wall());
            } else {
                out.writeNumberProperty("b", impact.b());
            }
            JsonNumbers.write(out, "ax", impact.ax());
            JsonNumbers.write(out, "ay", impact.ay());
            JsonNumbers.write(out, "bx", impact.bx());
            JsonNumbers.write(out, "by", impact.by());
            JsonNumbers.write(out, "impulse", impact.impulse());
            JsonNumbers.write(out, "energy", impact.energy());
            out.writeEndObject();
        }
        out.writeEndArray();
        if (log.impacts() > MOST) {
            out.writeNumberProperty("impactsInAll", log.impacts());
        }
    }

    /** Per body that was touched, in the order of first touch: its id and its corners (time, x, y). */
    private static void writePaths(JsonGenerator out, Game game, TurnLog log) {
        if (log.knots() == 0) {
            return;
        }
        int knots = Math.min(MOST, log.knots());
        out.writeArrayPropertyStart("paths");
        for (int first = 0; first < knots; first++) {
            if (isFirstOfBody(log, first)) {
                out.writeStartObject();
                out.writeNumberProperty("id", log.knotBody(first));
                out.writeArrayPropertyStart("knots");
                for (int k = first; k < knots; k++) {
                    if (log.knotBody(k) == log.knotBody(first)) {
                        out.writeStartArray();
                        JsonNumbers.write(out, log.knotTime(k));
                        JsonNumbers.write(out, log.knotX(k));
                        JsonNumbers.write(out, log.knotY(k));
                        out.writeEndArray();
                    }
                }
                out.writeEndArray();
                out.writeEndObject();
            }
        }
        out.writeEndArray();
    }

    private static boolean isFirstOfBody(TurnLog log, int knot) {
        for (int k = 0; k < knot; k++) {
            if (log.knotBody(k) == log.knotBody(knot)) {
                return false;
            }
        }
        return true;
    }

    private static void writeEvents(JsonGenerator out, List<TurnEvent> events) {
        if (events.isEmpty()) {
            return;
        }
        out.writeArrayPropertyStart("events");
        for (TurnEvent event : events) {
            out.writeStartObject();
            out.writeStringProperty("kind", event.kind().name().toLowerCase(Locale.ROOT));
            JsonNumbers.write(out, "time", event.time());
            if (event.body() >= 0) {
                out.writeNumberProperty("body", event.body());
            }
            JsonNumbers.write(out, "x", event.x());
            JsonNumbers.write(out, "y", event.y());
            if (!event.text().isEmpty()) {
                out.writeStringProperty("text", event.text());
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }
}
