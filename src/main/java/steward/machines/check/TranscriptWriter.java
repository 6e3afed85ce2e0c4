package steward.machines.check;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.function.ToLongFunction;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.GameJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Turn;
import steward.replay.TranscriptDigest;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Writer of a game as a worker sends it to its league: a replay without everything that follows from scene, seed and
 * commands. {@link TranscriptCheck} computes the rest. A transcript is several times shorter than a replay, and takes a
 * fraction of the time on both sides.
 *
 * <p>It has a line of JSON for the beginning, one for each turn, and one for the end. A turn in which nobody failed or
 * wrote anything is the array of its commands; others are objects. The last line has the measured times and a hash of
 * states (see {@link StatesHash}).
 */
public final class TranscriptWriter implements MatchListener {

    /** The field of the last line that no other has. */
    static final String STATES = "states";
    static final String NANOS = "answerNanos";
    /** The field of the last line that only games have in which a bot was held. */
    static final String HELD = "heldFrom";

    private final List<String> bots;
    private final String sandbox;
    private final LineBuffer text = new LineBuffer();
    private final LineBuffer nanos = new LineBuffer();
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), text);
    private final JsonGenerator times = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), nanos);
    private StatesHash states;
    private GameJson codec;

    /**
     * Before the game.
     *
     * @param bots    how they are started here, in order
     * @param sandbox the level at which they are kept apart
     */
    public TranscriptWriter(List<String> bots, String sandbox) {
        this.bots = List.copyOf(bots);
        this.sandbox = sandbox;
    }

    /** The transcript so far, compressed. */
    public byte[] compressed() {
        return GzipText.quickly(text.bytes(), text.size());
    }

    @Override
    public void start(Game startedGame, GameJson startedCodec) {
        codec = startedCodec;
        states = new StatesHash(startedGame);
        out.writeStartObject();
        JsonObject.writeTexts(out, "bots", bots);
        out.writeStringProperty("sandbox", sandbox);
        out.writeEndObject();
        endLine();
        times.writeStartArray();
    }

    private void endLine() {
        out.flush();
        text.write('\n');
    }

    @Override
    public void commands(Turn turn) {
        boolean plain = true;
        for (int player = 0; player < turn.players(); player++) {
            plain &= turn.fault(player) == null && turn.message(player) == null && turn.stderr(player) == null;
        }
        if (!plain) {
            out.writeStartObject();
            out.writeName("commands");
        }
        TranscriptDigest.write(out, turn, codec);
        for (int player = 0; player < turn.players(); player++) {
            if (turn.asked(player)) {
                times.writeNumber(turn.nanos(player));
            }
        }
        if (!plain) {
            write("faults", turn.players(), turn::fault);
            write("messages", turn.players(), turn::message);
            write("stderr", turn.players(), turn::stderr);
            out.writeEndObject();
        }
        endLine();
    }

    private void write(String name, int players, IntFunction<String> texts) {
        JsonObject.writeEach(out, name, players, player -> out.writeString(texts.apply(player)));
    }

    @Override
    public void played(Turn turn) {
        states.played();
    }

    @Override
    public void end(MatchResult result) {
        out.writeStartObject();
        out.writeStringProperty(STATES, states.hex());
        write("averageNanos", result, MatchResult.PlayerResult::averageNanos);
        write("worstNanos", result, MatchResult.PlayerResult::worstNanos);
        write("firstNanos", result, MatchResult.PlayerResult::firstNanos);
        write("earlyTurns", result, MatchResult.PlayerResult::earlyTurns);
        if (result.players().stream().anyMatch(player -> player.heldFrom() > 0)) {
            write(HELD, result, MatchResult.PlayerResult::heldFrom);
        }
        write("data", result.data());
        for (int player = 0; player < result.players().size(); player++) {
            write("data" + player, result.players().get(player).data());
        }
        times.writeEndArray();
        times.flush();
        out.writeName(NANOS);
        out.writeRawValue("");
        out.flush();
        text.write(nanos.bytes(), 0, nanos.size());
        out.writeEndObject();
        endLine();
    }

    private void write(String name, MatchResult result, ToLongFunction<MatchResult.PlayerResult> number) {
        JsonObject.writeEach(out, name, result.players(), player -> out.writeNumber(number.applyAsLong(player)));
    }

    private void write(String name, Map<String, String> data) {
        if (!data.isEmpty()) {
            out.writeObjectPropertyStart(name);
            new TreeMap<>(data).forEach(out::writeStringProperty);
            out.writeEndObject();
        }
    }
}
