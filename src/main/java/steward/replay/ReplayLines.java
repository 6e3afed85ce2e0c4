package steward.replay;

import java.util.Map;
import java.util.TreeMap;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.GameJson;
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
 * Lines of a replay from the first byte to the hash: the part that is equal whenever the same game is played. The
 * writer adds {@code times} and the end of the line. The verifier compares byte by byte with the recording, so that
 * every line has exactly one accepted form.
 *
 * <p>The hash of a line covers all bytes before it (see {@link InputHash}); it is the last field but {@code times}.
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
    private final ServerRecording server;
    private final LineBuffer line = new LineBuffer();
    /** Stays open across lines; opening one per line would cost time. */
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), line);
    private final StateHash hash = new StateHash();
    private final OutcomeJson outcome = new OutcomeJson();

    /** @param server what the site's server has recorded of the match, or {@code null} */
    public ReplayLines(ReplayHeader header, ServerRecording server) {
        this.header = header;
        this.server = server;
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

    public void header(Game game, GameJson codec) {
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
        if (server != null) {
            server.write(out, 0);
        }
        out.writeName("scene");
        out.writeRawValue(header.scene());
        writeOpening(out, game, codec);
        writeHash(new SerializedString(LineFields.HEADER_HASH));
    }

    /** The fields {@code drawing} and {@code start}: what follows from scene and seed alone. */
    public static void writeOpening(JsonGenerator out, Game game, GameJson codec) {
        out.writeObjectPropertyStart("drawing");
        codec.writeDrawing(out);
        out.writeEndObject();
        out.writeObjectPropertyStart("start");
        OutcomeJson.writeState(out, game, codec);
        out.writeEndObject();
    }

    /** A turn up to its commands and faults; they are known to the codec, and the turn is about to be played. */
    public void commands(Turn turn, GameJson codec) {
        open(TURN);
        JsonNumbers.write(out, Name.TURN, turn.number());
        out.writeName(Name.COMMANDS);
        TranscriptDigest.write(out, turn, codec);
        writeTexts("faults", Turn::fault, turn);
    }

    /** The rest of the turn, which has been played. */
    public void played(Turn turn, Game game, GameJson codec) {
        outcome(game, codec);
        texts(turn);
    }

    public void outcome(Game game, GameJson codec) {
        out.writeName(Name.OUTCOME);
        outcome.write(out, game, codec);
    }

    /** Writes the texts that the players said and wrote, and the hash. */
    public void texts(Turn turn) {
        writeTexts("messages", Turn::message, turn);
        writeTexts("stderr", Turn::stderr, turn);
        if (server != null) {
            server.write(out, turn.number());
        }
        writeHash(Name.TURN_HASH);
    }

    public void result(Game game, MatchResult result) {
        open(LineFields.RESULT_TYPE);
        out.writeNumberProperty("turns", result.turns());
        out.writeStringProperty("ending", result.ending());
        writeStanding(out, game);
        JsonObject.writeAll(out, "players", result.players(), player -> {
            out.writeStringProperty("name", player.name());
            if (player.fault() != null) {
                out.writeStringProperty("fault", player.fault());
            }
            writeData(player.data());
        });
        writeData(result.data());
        if (server != null) {
            server.writeEnd(out);
        }
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
    @FunctionalInterface
    private interface Text {
        String of(Turn turn, int player);
    }

    /** One text or null per player; left out if no player has one. */
    private void writeTexts(String name, Text text, Turn turn) {
        boolean any = false;
        for (int player = 0; player < turn.players(); player++) {
            any |= text.of(turn, player) != null;
        }
        if (!any) {
            return;
        }
        out.writeArrayPropertyStart(name);
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
