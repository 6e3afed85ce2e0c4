package steward.match;

import steward.Internal;
import steward.bot.LineBuffer;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.TextCodec;

/**
 * What is said to one kind of bot and how its answers are understood: a protocol bound to one game. The referee speaks
 * it, and a replay can say it again, because it follows from the game.
 */
@Internal
public interface Dialogue {

    /** The lines before the first turn, perhaps none; valid until the next call of any method that makes lines. */
    LineBuffer setup(int player);

    /** The lines of the turn about to be played. */
    LineBuffer turn(int player);

    /** The lines after the match, perhaps none. */
    LineBuffer end(int player);

    /** How many lines make an answer, at least 1. */
    int answerLines(int player);

    /** As {@link FrameCodec#readAnswer} and {@link TextCodec#readAnswer}. */
    String readAnswer(int player, byte[] answer, int length);

    /** The message that came with the player's last answer, or {@code null}. */
    String message(int player);

    /**
     * The dialogue of a protocol.
     *
     * @throws IllegalArgumentException if the scene's game does not speak it
     */
    static Dialogue of(Protocol protocol, GameSetup setup, Game game, FrameCodec codec) {
        return switch (protocol) {
            case JSON -> new JsonDialogue(setup, game, codec);
            case CODINGAME -> new TextDialogue(setup.textCodec(game).orElseThrow(() -> new IllegalArgumentException(
                "the scene \"" + setup.scene().name() + "\" has no codingame protocol, expected bots that speak"
                    + " json")));
        };
    }
}
