package steward.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.function.ToLongFunction;
import steward.bot.LineBuffer;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.JsonNumbers;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Turn;
import steward.numerics.StateHash;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.io.SerializedString;

/**
 * Writes a match as it is played, a line at a time; every line goes to the file in one piece as soon as it is complete,
 * so that a match that is killed leaves the turns it has played; see {@link WriteBehind} for how soon.
 */
public final class ReplayWriter implements MatchListener, AutoCloseable {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString TYPE = new SerializedString("type");
        static final SerializedString TURN = new SerializedString("turn");
        static final SerializedString COMMANDS = new SerializedString("commands");
        static final SerializedString INPUT_HASH = new SerializedString("inputHash");
        static final SerializedString OUTCOME = new SerializedString("outcome");
        static final SerializedString TIMES = new SerializedString("times");
        static final SerializedString ANSWER_NANOS = new SerializedString("answerNanos");
    }

    private final OutputStream file;
    private final ReplayHeader header;
    private final Observations observations;
    private final LineBuffer line = new LineBuffer();
    /** Stays open from line to line, which costs nothing. */
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), line);
    private final StateHash hash = new StateHash();
    private final OutcomeJson outcome = new OutcomeJson();
    private Game game;
    private FrameCodec codec;

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
        open(ReplayHeader.TYPE);
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
            writeObservedOpening();
        }
        writeHash("headerHash", 0);
        endLine();
    }

    private void writeObservedOpening() {
        writeDrawing(out, codec);
        out.writeObjectPropertyStart("start");
        out.writeObjectPropertyStart("state");
        observations.writeStart(out);
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
        codec.writeDrawing(out);
        out.writeEndObject();
    }

    @Override
    public void commands(Turn turn) {
        open("turn");
        JsonNumbers.write(out, Name.TURN, turn.number());
        out.writeName(Name.COMMANDS);
        out.flush();
        int from = line.size();
        out.writeStartArray();
        for (int player = 0; player < turn.players(); player++) {
            if (turn.answered(player)) {
                codec.writeCommand(out, player);
            } else {
                out.writeNull();
            }
        }
        out.writeEndArray();
        startHash(from);
        addTexts(Text.FAULT, turn);
        addTexts(Text.MESSAGE, turn);
        addTexts(Text.STDERR, turn);
        writeTexts(Text.FAULT, turn);
        out.writeName(Name.INPUT_HASH);
        JsonNumbers.writeHash(out, hash.value());
    }

    @Override
    public void played(Turn turn) {
        out.writeName(Name.OUTCOME);
        if (observations == null) {
            outcome.write(out, game, codec);
        } else {
            out.writeStartObject();
            observations.writeOutcome(out, turn.number());
            out.writeEndObject();
        }
        writeTexts(Text.MESSAGE, turn);
        writeTexts(Text.STDERR, turn);
        out.writeName(Name.TIMES);
        out.writeStartObject();
        out.writeName(Name.ANSWER_NANOS);
        out.writeStartArray();
        for (int player = 0; player < turn.players(); player++) {
            if (turn.asked(player)) {
                out.writeNumber(turn.nanos(player));
            } else {
                out.writeNull();
            }
        }
        out.writeEndArray();
        out.writeEndObject();
        endLine();
    }

    @Override
    public void end(MatchResult result) {
        open("result");
        out.writeNumberProperty("turns", result.turns());
        out.writeStringProperty("ending", result.ending());
        if (observations == null) {
            writeStanding(out, game);
        } else {
            writeObservedStanding();
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
        writeHash("resultHash", 0);
        out.writeObjectPropertyStart("times");
        writeNumbers(out, "averageNanos", result, MatchResult.PlayerResult::averageNanos);
        writeNumbers(out, "worstNanos", result, MatchResult.PlayerResult::worstNanos);
        writeNumbers(out, "firstNanos", result, MatchResult.PlayerResult::firstNanos);
        writeNumbers(out, "earlyTurns", result, MatchResult.PlayerResult::earlyTurns);
        out.writeEndObject();
        endLine();
        try {
            file.flush();
        } catch (IOException problem) {
            throw new UncheckedIOException("replay: cannot write: " + problem.getMessage(), problem);
        }
    }

    /** The field {@code data}: what bots reported; left out if they did not. */
    private static void writeData(JsonGenerator out, Map<String, String> data) {
        if (!data.isEmpty()) {
            out.writeObjectPropertyStart("data");
            data.forEach(out::writeStringProperty);
            out.writeEndObject();
        }
    }

    private void writeObservedStanding() {
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
    public static void writeStanding(JsonGenerator out, Game game) {
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

    /** A text of one player's turn, in the order in which they enter the hash. */
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

    private void addTexts(Text text, Turn turn) {
        for (int player = 0; player < turn.players(); player++) {
            InputHash.add(hash, text.of(turn, player));
        }
    }

    /** One text or null per player; left out if nobody has any. */
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
            if (text.of(turn, player) == null) {
                out.writeNull();
            } else {
                out.writeString(text.of(turn, player));
            }
        }
        out.writeEndArray();
    }

    /** Begins a hash of the line with what was written from there on, a colon left out. */
    private void startHash(int from) {
        out.flush();
        byte[] bytes = line.bytes();
        InputHash.add(hash.reset(), ReplayHeader.FORMAT, bytes, bytes[from] == ':' ? from + 1 : from, line.size());
    }

    private void writeHash(String name, int from) {
        startHash(from);
        out.writeName(name);
        JsonNumbers.writeHash(out, hash.value());
    }

    private void open(String type) {
        line.reset();
        out.writeStartObject();
        out.writeName(Name.TYPE);
        out.writeString(type);
    }

    private void endLine() {
        out.writeEndObject();
        out.flush();
        line.write('\n');
        try {
            file.write(line.bytes(), 0, line.size());
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
}
