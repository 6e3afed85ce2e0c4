package steward.replay;

import java.util.List;
import java.util.Locale;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.TurnEvent;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.json.RawJson;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/**
 * JSON of what follows from a turn's commands: impacts, paths, events, the ending by the impact limit, the state and
 * its hash. Empty parts are left out. The writer records it; the verifier writes it again and compares.
 */
public final class OutcomeJson {

    /** How many impacts of a turn are kept, and how many knots of paths: a turn can have over ten thousand impacts. */
    private static final int MOST = TurnLog.RECORDED;

    private static final int MOST_BODIES = 2000;

    /** The names that turns write, encoded once. */
    private static final class Name {
        static final SerializedString TIME = new SerializedString("time");
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

    private static final byte[] TIME = RawJson.text("{\"time\":");
    private static final byte[] A = RawJson.text(",\"a\":");
    private static final byte[] B = RawJson.text(",\"b\":");
    private static final byte[] WALL = RawJson.text(",\"wall\":");
    private static final byte[] AX = RawJson.text(",\"ax\":");
    private static final byte[] AY = RawJson.text(",\"ay\":");
    private static final byte[] BX = RawJson.text(",\"bx\":");
    private static final byte[] BY = RawJson.text(",\"by\":");
    private static final byte[] IMPULSE = RawJson.text(",\"impulse\":");
    private static final byte[] ENERGY = RawJson.text(",\"energy\":");
    private static final byte[] KNOT = RawJson.text("[");

    private final RawJson text = new RawJson();

    /** One object: the outcome of the turn just played. */
    public void write(JsonGenerator out, Game game, GameJson codec) {
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
        codec.writeProgress(out);
        if (hasState(game)) {
            writeState(out, game, codec);
        } else {
            writeHash(out, game);
        }
        out.writeEndObject();
    }

    /** The fields {@code state} and {@code hash}. */
    static void writeState(JsonGenerator out, Game game, GameJson codec) {
        out.writeName(Name.STATE);
        out.writeStartObject();
        codec.writeState(out);
        out.writeEndObject();
        writeHash(out, game);
    }

    private static void writeHash(JsonGenerator out, Game game) {
        out.writeName(Name.HASH);
        JsonNumbers.writeHash(out, game.hash());
    }

    /**
     * True if the state of the turn just played is kept. With more than {@value #MOST_BODIES} bodies a replay is
     * sparse: so many states are left out that of each turn that many bodies are kept on average; the last is there.
     */
    public static boolean hasState(Game game) {
        int every = (game.bodies().size() + MOST_BODIES - 1) / MOST_BODIES;
        return every <= 1 || game.isOver() || game.turn() % every == 0;
    }

    private void writeImpacts(JsonGenerator out, TurnLog log) {
        if (log.impacts() == 0) {
            return;
        }
        out.writeName(Name.IMPACTS);
        out.writeStartArray();
        for (int k = 0; k < Math.min(MOST, log.kept()); k++) {
            out.writeRawValue(impact(log, k));
        }
        out.writeEndArray();
        if (log.impacts() > MOST) {
            JsonNumbers.write(out, Name.IMPACTS_IN_ALL, log.impacts());
        }
    }

    /** Of the numbers of an {@link Impact}: ax, ay, bx, by, impulse, energy. */
    private RawJson impact(TurnLog log, int k) {
        int b = log.impactB(k);
        return text.begin(TIME).add(log.impactTime(k)).add(A).add(log.impactA(k)).add(b < 0 ? WALL : B)
            .add(b < 0 ? ~b : b).add(AX).add(log.impactNumber(k, 0)).add(AY).add(log.impactNumber(k, 1))
            .add(BX).add(log.impactNumber(k, 2)).add(BY).add(log.impactNumber(k, 3))
            .add(IMPULSE).add(log.impactNumber(k, 6)).add(ENERGY).add(log.impactNumber(k, 7)).add('}');
    }

    /** Per body that was touched, in the order of first touch: its id and its corners (time, x, y). */
    private void writePaths(JsonGenerator out, Game game, TurnLog log) {
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
                        out.writeRawValue(text.begin(KNOT).add(log.knotTime(k)).add(',').add(log.knotX(k)).add(',')
                            .add(log.knotY(k)).add(']'));
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
        JsonObject.writeAll(out, "events", events, event -> {
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
        });
    }
}
