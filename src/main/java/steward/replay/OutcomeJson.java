package steward.replay;

import java.util.List;
import java.util.Locale;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.JsonNumbers;
import steward.game.TurnEvent;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/**
 * Writes what follows from the commands: impacts, paths, events, the ending by the impact limit, the state and its
 * hash. What is empty is left out. The writer records it, the verifier writes it again and compares.
 */
final class OutcomeJson {

    /** A turn can have over ten thousand impacts; the first so many of them are kept, and so many corners of paths. */
    private static final int MOST = 2000;

    /** The names that turns write, encoded once. */
    private static final class Name {
        static final SerializedString TIME = new SerializedString("time");
        static final SerializedString AX = new SerializedString("ax");
        static final SerializedString AY = new SerializedString("ay");
        static final SerializedString BX = new SerializedString("bx");
        static final SerializedString BY = new SerializedString("by");
        static final SerializedString IMPULSE = new SerializedString("impulse");
        static final SerializedString ENERGY = new SerializedString("energy");
        static final SerializedString A = new SerializedString("a");
        static final SerializedString WALL = new SerializedString("wall");
        static final SerializedString B = new SerializedString("b");
        static final SerializedString IMPACTS_IN_ALL = new SerializedString("impactsInAll");
        static final SerializedString ID = new SerializedString("id");
        static final SerializedString IMPACT_LIMIT = new SerializedString("impactLimit");
        static final SerializedString BODIES = new SerializedString("bodies");
        static final SerializedString STATE = new SerializedString("state");
        static final SerializedString IMPACTS = new SerializedString("impacts");
        static final SerializedString PATHS = new SerializedString("paths");
        static final SerializedString KNOTS = new SerializedString("knots");
        static final SerializedString HASH = new SerializedString("hash");
    }

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
            out.writeName(Name.IMPACT_LIMIT);
            out.writeStartObject();
            JsonNumbers.write(out, Name.TIME, log.limitTime());
            out.writeName(Name.BODIES);
            out.writeStartArray();
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
        out.writeName(Name.STATE);
        out.writeStartObject();
        codec.writeState(out);
        out.writeEndObject();
        out.writeName(Name.HASH);
        JsonNumbers.writeHash(out, game.hash());
    }

    private static void writeImpacts(JsonGenerator out, TurnLog log) {
        if (log.impacts() == 0) {
            return;
        }
        out.writeName(Name.IMPACTS);
        out.writeStartArray();
        for (int k = 0; k < Math.min(MOST, log.impacts()); k++) {
            Impact impact = log.impact(k);
            out.writeStartObject();
            JsonNumbers.write(out, Name.TIME, impact.time());
            JsonNumbers.write(out, Name.A, impact.a());
            if (impact.isWall()) {
                JsonNumbers.write(out, Name.WALL, impact.wall());
            } else {
                JsonNumbers.write(out, Name.B, impact.b());
            }
            JsonNumbers.write(out, Name.AX, impact.ax());
            JsonNumbers.write(out, Name.AY, impact.ay());
            JsonNumbers.write(out, Name.BX, impact.bx());
            JsonNumbers.write(out, Name.BY, impact.by());
            JsonNumbers.write(out, Name.IMPULSE, impact.impulse());
            JsonNumbers.write(out, Name.ENERGY, impact.energy());
            out.writeEndObject();
        }
        out.writeEndArray();
        if (log.impacts() > MOST) {
            JsonNumbers.write(out, Name.IMPACTS_IN_ALL, log.impacts());
        }
    }

    /** Per body that was touched, in the order of first touch: its id and its corners (time, x, y). */
    private static void writePaths(JsonGenerator out, Game game, TurnLog log) {
        if (log.knots() == 0) {
            return;
        }
        int knots = Math.min(MOST, log.knots());
        out.writeName(Name.PATHS);
        out.writeStartArray();
        for (int first = 0; first < knots; first++) {
            if (isFirstOfBody(log, first)) {
                out.writeStartObject();
                JsonNumbers.write(out, Name.ID, log.knotBody(first));
                out.writeName(Name.KNOTS);
                out.writeStartArray();
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
