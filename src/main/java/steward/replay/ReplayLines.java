package steward.replay;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import steward.bot.LineBuffer;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.MatchResult;
import steward.match.Turn;
import steward.numerics.StateHash;
import steward.scene.Time;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.io.SerializedString;

/**
 * Writes the lines of a replay, from the first byte to the hash: the part that is the same whenever the same game is
 * played. The writer adds {@code times} and the end of the line; the verifier compares byte by byte with what was
 * recorded, so that every line has exactly one accepted form.
 *
 * <p>The hash of a line is that of all bytes before it, see {@link InputHash}; it is the last field but {@code times}.
 */
public final class ReplayLines {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString TYPE = new SerializedString("type");
        static final SerializedString TURN = new SerializedString("turn");
        static final SerializedString COMMANDS = new SerializedString("commands");
        static final SerializedString OUTCOME = new SerializedString("outcome");
        static final SerializedString TURN_HASH = new SerializedString(LineFields.TURN_HASH);
    }

    private static final SerializedString TURN = new SerializedString("turn");

    private final ReplayHeader header;
    private final Observations observations;
    private final LineBuffer line = new LineBuffer();
    /** Stays open across lines; opening one per line would cost time. */
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), line);
    private final StateHash hash = new StateHash();
    private final OutcomeJson outcome = new OutcomeJson();

    /** @param observations what another referee saw, kept in place of our outcomes; or {@code null} */
    public ReplayLines(ReplayHeader header, Observations observations) {
        this.header = header;
        this.observations = observations;
    }

    /** The line as far as it is written; reused from line to line. */
    public LineBuffer line() {
        out.flush();
        return line;
    }

    /** Ends the object, not the line. */
    public LineBuffer end() {
        out.writeEndObject();
        return line();
    }

    /** For adding fields behind the hash. */
    JsonGenerator out() {
        return out;
    }

    public void header(Game game, FrameCodec codec) {
        open(ReplayHeader.TYPE);
        out.writeNumberProperty("format", ReplayHeader.FORMAT);
        if (header.law() > 1) {
            out.writeNumberProperty(LineFields.LAW, header.law());
        }
        out.writeStringProperty("angles", ReplayHeader.ANGLES);
        out.writeStringProperty("game", header.game());
        if (header.jar() != null) {
            out.writeStringProperty(LineFields.JAR, header.jar());
        }
        out.writeStringProperty("seed", Long.toString(header.seed()));
        JsonObject.writeAll(out, "players", header.names().size(), player -> {
            out.writeStringProperty("name", header.names().get(player));
            out.writeStringProperty("bot", header.bots().get(player));
            out.writeStringProperty("protocol", header.protocols().get(player).word());
            Time own = header.limits().get(player);
            if (own != null) {
                out.writeObjectPropertyStart(LineFields.TIME);
                out.writeNumberProperty(LineFields.FIRST_ANSWER, own.firstAnswerMs());
                out.writeNumberProperty(LineFields.ANSWER, own.answerMs());
                out.writeEndObject();
            }
        });
        out.writeName("timeFactor");
        if (header.timeFactor() < Double.POSITIVE_INFINITY) {
            JsonNumbers.write(out, header.timeFactor());
        } else {
            out.writeNull();
        }
        if (header.signer() != null) {
            out.writeStringProperty("signer", header.signer());
        }
        if (observations != null) {
            out.writeBooleanProperty("imported", true);
        }
        out.writeName("scene");
        out.writeRawValue(header.scene());
        if (observations == null || !observations.hasStart()) {
            writeOpening(out, game, codec);
        } else {
            writeShownOpening(out, codec, observations::writeStart);
        }
        writeHash(new SerializedString(LineFields.HEADER_HASH));
    }

    /**
     * Writes as {@link #writeOpening} does, of a match that a server played. @param state writes the fields that it
     * shows
     */
    public static void writeShownOpening(JsonGenerator out, FrameCodec codec, Consumer<JsonGenerator> state) {
        writeDrawing(out, codec);
        out.writeObjectPropertyStart("start");
        out.writeObjectPropertyStart("state");
        state.accept(out);
        out.writeEndObject();
        out.writeEndObject();
    }

    /** The fields {@code drawing} and {@code start}: what follows from scene and seed alone. */
    public static void writeOpening(JsonGenerator out, Game game, FrameCodec codec) {
        writeDrawing(out, codec);
        out.writeObjectPropertyStart("start");
        OutcomeJson.writeState(out, game, codec);
        out.writeEndObject();
    }

    private static void writeDrawing(JsonGenerator out, FrameCodec codec) {
        out.writeObjectPropertyStart("drawing");
        codec.drawing().write(out);
        out.writeEndObject();
    }

    /** A turn up to its commands and faults; they are known to the codec, and the turn is about to be played. */
    public void commands(Turn turn, FrameCodec codec) {
        open(TURN);
        JsonNumbers.write(out, Name.TURN, turn.number());
        out.writeName(Name.COMMANDS);
        TranscriptDigest.write(out, turn, codec);
        writeTexts(Text.FAULT, turn);
    }

    /** The rest of the turn, which has been played. */
    public void played(Turn turn, Game game, FrameCodec codec) {
        outcome(turn, game, codec);
        texts(turn);
    }

    public void outcome(Turn turn, Game game, FrameCodec codec) {
        out.writeName(Name.OUTCOME);
        if (observations == null) {
            outcome.write(out, game, codec);
        } else {
            out.writeStartObject();
            observations.writeOutcome(out, turn.number());
            out.writeEndObject();
        }
    }

    /** Writes the texts that the players said and wrote, and the hash. */
    public void texts(Turn turn) {
        writeTexts(Text.MESSAGE, turn);
        writeTexts(Text.STDERR, turn);
        writeHash(Name.TURN_HASH);
    }

    public void result(Game game, MatchResult result) {
        open("result");
        out.writeNumberProperty("turns", result.turns());
        out.writeStringProperty("ending", result.ending());
        if (observations == null) {
            writeStanding(out, game);
        } else {
            writeObservedStanding(game);
        }
        JsonObject.writeAll(out, "players", result.players(), player -> {
            out.writeStringProperty("name", player.name());
            if (player.fault() != null) {
                out.writeStringProperty("fault", player.fault());
            }
            writeData(player.data());
        });
        writeData(result.data());
        writeHash(new SerializedString(LineFields.RESULT_HASH));
    }

    /** The field {@code data}: what bots reported; left out if they did not. */
    private void writeData(Map<String, String> data) {
        if (!data.isEmpty()) {
            out.writeObjectPropertyStart("data");
            new TreeMap<>(data).forEach(out::writeStringProperty);
            out.writeEndObject();
        }
    }

    private void writeObservedStanding(Game game) {
        int[] ranks = game.ranks();
        double[] scores = game.scores();
        out.writeArrayPropertyStart("standing");
        for (int player = 0; player < ranks.length; player++) {
            int observed = observations.rank(player);
            out.writeStartObject();
            out.writeNumberProperty("rank", observed < 0 ? ranks[player] : observed);
            double score = observations.score(player);
            JsonNumbers.write(out, "score", Double.isFinite(score) ? score : scores[player]);
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** The field {@code standing}: what the game itself says of each player at the end. */
    public static void writeStanding(JsonGenerator out, Game game) {
        int[] ranks = game.ranks();
        double[] scores = game.scores();
        JsonObject.writeAll(out, "standing", ranks.length, player -> {
            out.writeNumberProperty("rank", ranks[player]);
            JsonNumbers.write(out, "score", scores[player]);
            if (!game.isIn(player)) {
                out.writeStringProperty("out", game.eliminationReason(player));
            }
        });
    }

    /** A text of one player's turn. */
    private enum Text {
        FAULT("faults"),
        MESSAGE("messages"),
        STDERR("stderr");

        private final String name;

        Text(String name) {
            this.name = name;
        }

        String of(Turn turn, int player) {
            return switch (this) {
                case FAULT -> turn.fault(player);
                case MESSAGE -> turn.message(player);
                case STDERR -> turn.stderr(player);
            };
        }
    }

    /** One text or null per player; left out if no player has one. */
    private void writeTexts(Text text, Turn turn) {
        boolean any = false;
        for (int player = 0; player < turn.players(); player++) {
            any |= text.of(turn, player) != null;
        }
        if (!any) {
            return;
        }
        out.writeArrayPropertyStart(text.name);
        for (int player = 0; player < turn.players(); player++) {
            out.writeString(text.of(turn, player));
        }
        out.writeEndArray();
    }

    /** The hash of the line so far. */
    private void writeHash(SerializedString name) {
        out.flush();
        InputHash.add(hash.reset(), line.bytes(), 0, line.size());
        out.writeName(name);
        JsonNumbers.writeHash(out, hash.value());
    }

    private void open(String type) {
        open(new SerializedString(type));
    }

    private void open(SerializedString type) {
        line.reset();
        out.writeStartObject();
        out.writeName(Name.TYPE);
        out.writeString(type);
    }
}
