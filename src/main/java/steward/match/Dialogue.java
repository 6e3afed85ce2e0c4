package steward.match;

import java.util.Map;
import steward.Internal;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.TextCodec;
import steward.scene.Time;

/**
 * Protocol bound to one game: produces the lines sent to a bot and reads its answers. The referee uses it; a replay can
 * produce the same lines again, because they depend on the game alone.
 */
public interface Dialogue {

    /** The lines before the first turn, possibly empty; valid until the next call of any method that makes lines. */
    LineBuffer setup(int player);

    /** The lines of the turn that is played next. */
    LineBuffer turn(int player);

    /** The lines after the match, possibly empty. */
    LineBuffer end(int player);

    /** Returns how many lines make an answer, at least 1. */
    int answerLines(int player);

    /** As {@link GameJson#readAnswer} and {@link TextCodec#readAnswer}. */
    String readAnswer(int player, byte[] answer, int length);

    /** The message that came with the player's last answer, or {@code null}. */
    String message(int player);

    /**
     * The dialogue of a protocol.
     *
     * @param limits of players that have their own
     * @throws IllegalArgumentException if the scene's game does not support it
     */
    @Internal
    static Dialogue of(Protocol protocol, GameSetup setup, Game game, GameJson codec, Map<Integer, Time> limits) {
        return switch (protocol) {
            case JSON -> new JsonDialogue(setup, game, codec, limits);
            case CODINGAME -> new TextDialogue(setup.textCodec(game).orElseThrow(() -> new IllegalArgumentException(
                "the scene \"" + setup.scene().name() + "\" has no codingame protocol, expected bots that speak"
                    + " json")));
        };
    }
}
