package steward.replay;

import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.GameJson;
import steward.json.JsonNumbers;
import steward.match.Turn;
import steward.numerics.StateHash;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Digest of a game's transcript: 64 bits over all commands, as a replay writes them, and the hash of the state after
 * each turn. Two games with the same digest were the same game, whatever their seeds were.
 *
 * <p>Not thread-safe. Its cost per turn is writing the commands.
 */
public final class TranscriptDigest {

    private final LineBuffer commands = new LineBuffer();
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), commands);
    private final StateHash hash = new StateHash();

    /** Adds the commands of a turn that is about to be played. */
    public void commands(Turn turn, GameJson codec) {
        commands.reset();
        write(out, turn, codec);
        out.flush();
        InputHash.add(hash, commands.bytes(), 0, commands.size());
    }

    /** Adds the state after the turn. */
    public void played(Game game) {
        hash.add(game.hash());
    }

    /** The digest so far; never 0. */
    public long value() {
        return hash.value() == 0 ? 1 : hash.value();
    }

    /** Writes an array of commands, one for each player, or null. Allocates nothing: matches write it in each turn. */
    public static void write(JsonGenerator out, Turn turn, GameJson codec) {
        out.writeStartArray();
        for (int player = 0; player < turn.players(); player++) {
            if (turn.answered(player) || turn.asked(player) && codec.hasPartialCommand(player)) {
                codec.writeCommand(out, player);
            } else {
                out.writeNull();
            }
        }
        out.writeEndArray();
    }
}
