package steward.replay;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.Map;
import java.util.Objects;
import java.util.function.ToLongFunction;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.JsonNumbers;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Turn;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Writes a match as it is played, a line at a time; every complete line is handed to the operating system at once, so
 * that a match that is killed leaves all turns it has played.
 */
public final class ReplayWriter implements MatchListener, AutoCloseable {

    private final OutputStream file;
    private final ReplayHeader header;
    private final Observations observations;
    private final Line line = new Line();
    private Game game;
    private FrameCodec codec;
    private JsonGenerator turnLine;

    /** @param file unbuffered is best: it is written once per line; closed by {@link #close} */
    public ReplayWriter(OutputStream file, ReplayHeader header) {
        this(file, header, null);
    }

    /** Of a match that another referee has played: keeps what was observed in place of what we would record. */
    public ReplayWriter(OutputStream file, ReplayHeader header, Observations observations) {
        this.file = file;
        this.header = header;
        this.observations = observations;
    }

    @Override
    public void start(Game startedGame, FrameCodec startedCodec) {
        game = startedGame;
        codec = startedCodec;
        JsonGenerator out = open(ReplayHeader.TYPE);
        out.writeNumberProperty("format", ReplayHeader.FORMAT);
        out.writeStringProperty("game", header.game());
        out.writeStringProperty("seed", Long.toString(header.seed()));
        out.writeArrayPropertyStart("players");
        for (int player = 0; player < header.names().size(); player++) {
            out.writeStartObject();
            out.writeStringProperty("name", header.names().get(player));
            out.writeStringProperty("bot", header.bots().get(player));
            out.writeStringProperty("protocol", header.protocols().get(player).word());
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeName("timeFactor");
        if (header.timeFactor() < Double.POSITIVE_INFINITY) {
            JsonNumbers.write(out, header.timeFactor());
        } else {
            out.writeNull();
        }
        if (observations != null) {
            out.writeBooleanProperty("imported", true);
        }
        out.writeName("scene");
        out.writeRawValue(header.scene());
        if (observations == null || !observations.hasStart()) {
            writeOpening(out, game, codec);
        } else {
            writeObservedOpening(out);
        }
        out.flush();
        out.writeStringProperty("headerHash", line.hash(0));
        close(out);
    }

    private void writeObservedOpening(JsonGenerator out) {
        writeDrawing(out, codec);
        out.writeObjectPropertyStart("start");
        out.writeObjectPropertyStart("state");
        observations.writeStart(out);
        out.writeEndObject();
        out.writeEndObject();
    }

    /** The fields {@code drawing} and {@code start}: what follows from scene and seed alone. */
    static void writeOpening(JsonGenerator out, Game game, FrameCodec codec) {
        writeDrawing(out, codec);
        out.writeObjectPropertyStart("start");
        OutcomeJson.writeState(out, game, codec);
        out.writeEndObject();
    }

    private static void writeDrawing(JsonGenerator out, FrameCodec codec) {
        out.writeObjectPropertyStart("drawing");
        codec.writeDrawing(out);
        out.writeEndObject();
    }

    @Override
    public void commands(Turn turn) {
        turnLine = open("turn");
        turnLine.writeNumberProperty("turn", turn.number());
        turnLine.writeName("commands");
        turnLine.flush();
        int from = line.size();
        turnLine.writeStartArray();
        for (int player = 0; player < turn.players(); player++) {
            if (turn.answered(player)) {
                codec.writeCommand(turnLine, player);
            } else {
                turnLine.writeNull();
            }
        }
        turnLine.writeEndArray();
        turnLine.flush();
        String inputHash = line.hash(from, texts(turn, Turn::fault), texts(turn, Turn::message),
            texts(turn, Turn::stderr));
        writeTexts(turnLine, "faults", turn, Turn::fault);
        turnLine.writeStringProperty("inputHash", inputHash);
    }

    @Override
    public void played(Turn turn) {
        turnLine.writeName("outcome");
        if (observations == null) {
            OutcomeJson.write(turnLine, game, codec);
        } else {
            turnLine.writeStartObject();
            observations.writeOutcome(turnLine, turn.number());
            turnLine.writeEndObject();
        }
        writeTexts(turnLine, "messages", turn, Turn::message);
        writeTexts(turnLine, "stderr", turn, Turn::stderr);
        turnLine.writeObjectPropertyStart("times");
        turnLine.writeArrayPropertyStart("answerNanos");
        for (int player = 0; player < turn.players(); player++) {
            if (turn.asked(player)) {
                turnLine.writeNumber(turn.nanos(player));
            } else {
                turnLine.writeNull();
            }
        }
        turnLine.writeEndArray();
        turnLine.writeEndObject();
        close(turnLine);
    }

    @Override
    public void end(MatchResult result) {
        JsonGenerator out = open("result");
        out.writeNumberProperty("turns", result.turns());
        out.writeStringProperty("ending", result.ending());
        if (observations == null) {
            writeStanding(out, game);
        } else {
            writeObservedStanding(out);
        }
        out.writeArrayPropertyStart("players");
        for (MatchResult.PlayerResult player : result.players()) {
            out.writeStartObject();
            out.writeStringProperty("name", player.name());
            if (player.fault() != null) {
                out.writeStringProperty("fault", player.fault());
            }
            writeData(out, player.data());
            out.writeEndObject();
        }
        out.writeEndArray();
        writeData(out, result.data());
        out.flush();
        out.writeStringProperty("resultHash", line.hash(0));
        out.writeObjectPropertyStart("times");
        writeNumbers(out, "averageNanos", result, MatchResult.PlayerResult::averageNanos);
        writeNumbers(out, "worstNanos", result, MatchResult.PlayerResult::worstNanos);
        writeNumbers(out, "firstNanos", result, MatchResult.PlayerResult::firstNanos);
        writeNumbers(out, "earlyTurns", result, MatchResult.PlayerResult::earlyTurns);
        out.writeEndObject();
        close(out);
    }

    /** The field {@code data}: what bots reported; left out if they did not. */
    private static void writeData(JsonGenerator out, Map<String, String> data) {
        if (!data.isEmpty()) {
            out.writeObjectPropertyStart("data");
            data.forEach(out::writeStringProperty);
            out.writeEndObject();
        }
    }

    private void writeObservedStanding(JsonGenerator out) {
        int[] ranks = game.ranks();
        double[] scores = game.scores();
        out.writeArrayPropertyStart("standing");
        for (int player = 0; player < ranks.length; player++) {
            int observed = observations.rank(player);
            out.writeStartObject();
            out.writeNumberProperty("rank", observed < 0 ? ranks[player] : observed);
            JsonNumbers.write(out, "score", scores[player]);
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** The field {@code standing}: what the game itself says of each player at the end. */
    static void writeStanding(JsonGenerator out, Game game) {
        int[] ranks = game.ranks();
        double[] scores = game.scores();
        out.writeArrayPropertyStart("standing");
        for (int player = 0; player < ranks.length; player++) {
            out.writeStartObject();
            out.writeNumberProperty("rank", ranks[player]);
            JsonNumbers.write(out, "score", scores[player]);
            if (!game.isIn(player)) {
                out.writeStringProperty("out", game.eliminationReason(player));
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private static void writeNumbers(JsonGenerator out, String name, MatchResult result,
                                   ToLongFunction<MatchResult.PlayerResult> number) {
        out.writeArrayPropertyStart(name);
        for (MatchResult.PlayerResult player : result.players()) {
            out.writeNumber(number.applyAsLong(player));
        }
        out.writeEndArray();
    }

    /** A text of one player's turn. */
    private interface Text {
        String of(Turn turn, int player);
    }

    private static String[] texts(Turn turn, Text text) {
        String[] texts = new String[turn.players()];
        for (int player = 0; player < texts.length; player++) {
            texts[player] = text.of(turn, player);
        }
        return texts;
    }

    private static void writeTexts(JsonGenerator out, String name, Turn turn, Text text) {
        String[] texts = texts(turn, text);
        if (Arrays.stream(texts).allMatch(Objects::isNull)) {
            return;
        }
        out.writeArrayPropertyStart(name);
        for (String value : texts) {
            if (value == null) {
                out.writeNull();
            } else {
                out.writeString(value);
            }
        }
        out.writeEndArray();
    }

    private JsonGenerator open(String type) {
        line.reset();
        JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), line);
        out.writeStartObject();
        out.writeStringProperty("type", type);
        return out;
    }

    private void close(JsonGenerator out) {
        out.writeEndObject();
        out.close();
        line.write('\n');
        try {
            line.writeTo(file);
            file.flush();
        } catch (IOException problem) {
            throw new UncheckedIOException("replay: cannot write: " + problem.getMessage(), problem);
        }
    }

    @Override
    public void close() {
        try {
            file.close();
        } catch (IOException problem) {
            throw new UncheckedIOException("replay: cannot close: " + problem.getMessage(), problem);
        }
    }

    /** Collects one line. */
    private static final class Line extends ByteArrayOutputStream {
        Line() {
            super(8192);
        }

        /** The hash of what is written from there on, a colon left out, and of texts. */
        String hash(int from, String[]... texts) {
            return InputHash.of(buf, buf[from] == ':' ? from + 1 : from, count, texts);
        }
    }
}
