package steward.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.function.ToLongFunction;
import steward.Internal;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.GameJson;
import steward.json.JsonObject;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Turn;
import steward.replay.sign.LinesDigest;
import steward.replay.sign.SigningKey;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/**
 * Writer of a match to a replay as the match is played, one line at a time. Every complete line goes to the file in one
 * piece, so that a match that is killed leaves the turns it has played; {@link WriteBehind} says how soon.
 *
 * <p>A signed match names its signer in the header, and its signature follows the result, in one piece with it ({@link
 * LinesDigest} says what is signed). A match without a result has no signature.
 */
public final class ReplayWriter implements MatchListener, AutoCloseable {

    private static final SerializedString TIMES = new SerializedString(LineFields.TIMES);
    private static final SerializedString ANSWER_NANOS = new SerializedString("answerNanos");

    private final OutputStream file;
    private final ReplayLines lines;
    private final JsonGenerator out;
    private final String sandbox;
    private final SigningKey key;
    private final String isolation;
    private final LinesDigest digest;
    private Game game;
    private GameJson codec;
    private boolean timed = true;

    /** @param file unbuffered is best: it is written once per line; closed by {@link #close} */
    public ReplayWriter(OutputStream file, ReplayHeader header) {
        this(file, header, null, null);
    }

    /** For a match that the site's server has played: what it has recorded is kept beside. */
    @Internal
    public ReplayWriter(OutputStream file, ReplayHeader header, ServerRecording server) {
        this(file, header, server, null, null);
    }

    /**
     * @param key       to sign with, or {@code null}
     * @param isolation how bots are kept apart, which is signed as well: words without quotes
     */
    @Internal
    public ReplayWriter(OutputStream file, ReplayHeader header, SigningKey key, String isolation) {
        this(file, header, null, key, isolation);
    }

    private ReplayWriter(OutputStream file, ReplayHeader header, ServerRecording server, SigningKey key,
                         String isolation) {
        this.file = file;
        this.key = key;
        this.isolation = isolation;
        sandbox = header.sandbox();
        lines = new ReplayLines(header.signedBy(key == null ? null : key.publicKey().text()), server);
        out = lines.out();
        digest = key == null ? null : new LinesDigest();
    }

    /** Leaves out all times: nobody has measured the players of this match. @return this */
    @Internal
    public ReplayWriter untimed() {
        timed = false;
        return this;
    }

    @Override
    public void start(Game startedGame, GameJson startedCodec) {
        game = startedGame;
        codec = startedCodec;
        lines.header(game, codec);
        sign();
        if (sandbox != null) {
            out.writeName(TIMES);
            out.writeStartObject();
            out.writeStringProperty("sandbox", sandbox);
            out.writeEndObject();
        }
        write(endLine());
    }

    @Override
    public void commands(Turn turn) {
        lines.commands(turn, codec);
    }

    @Override
    public void played(Turn turn) {
        lines.played(turn, game, codec);
        sign();
        if (timed) {
            writeAnswerTimes(turn);
        }
        write(endLine());
    }

    private void writeAnswerTimes(Turn turn) {
        out.writeName(TIMES);
        out.writeStartObject();
        out.writeName(ANSWER_NANOS);
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
    }

    @Override
    public void end(MatchResult result) {
        lines.result(game, result);
        sign();
        if (timed) {
            out.writeName(TIMES);
            out.writeStartObject();
            writeNumbers(out, "averageNanos", result, MatchResult.PlayerResult::averageNanos);
            writeNumbers(out, "worstNanos", result, MatchResult.PlayerResult::worstNanos);
            writeNumbers(out, "firstNanos", result, MatchResult.PlayerResult::firstNanos);
            writeNumbers(out, "earlyTurns", result, MatchResult.PlayerResult::earlyTurns);
            if (result.players().stream().anyMatch(player -> player.heldFrom() > 0)) {
                writeNumbers(out, "heldFrom", result, MatchResult.PlayerResult::heldFrom);
            }
            out.writeEndObject();
        }
        LineBuffer last = endLine();
        if (key != null) {
            byte[] signature = signatureLine(key.sign(digest.message(isolation)), isolation)
                .getBytes(StandardCharsets.UTF_8);
            last.write(signature, 0, signature.length);
            last.write('\n');
        }
        write(last);
        try {
            file.flush();
        } catch (IOException problem) {
            throw new UncheckedIOException("replay: cannot write: " + problem.getMessage(), problem);
        }
    }

    /** The line of a signature, without its end. */
    static String signatureLine(String signature, String isolation) {
        return "{\"type\":\"signature\"," + (isolation == null ? "" : "\"isolation\":\"" + isolation + "\",")
            + "\"signature\":\"" + signature + "\"}";
    }

    private static void writeNumbers(JsonGenerator out, String name, MatchResult result,
                                   ToLongFunction<MatchResult.PlayerResult> number) {
        JsonObject.writeEach(out, name, result.players(), player -> out.writeNumber(number.applyAsLong(player)));
    }

    /** Adds the line up to here to what is signed. */
    private void sign() {
        if (digest != null) {
            LineBuffer line = lines.line();
            digest.add(line.bytes(), line.size());
        }
    }

    private LineBuffer endLine() {
        LineBuffer line = lines.end();
        line.write('\n');
        return line;
    }

    private void write(LineBuffer line) {
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
