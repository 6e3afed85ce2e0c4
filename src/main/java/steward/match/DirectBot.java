package steward.match;

import steward.game.Game;

/**
 * A bot inside this JVM that reads the game itself and gives commands directly to it, without lines or JSON. A match
 * with such bots gives the same result and the same recording as one in which the same commands are sent as lines.
 *
 * <p>One instance plays one match; the methods are called by one thread at a time. The bot must change the game only by
 * giving commands, for which each game has its own class.
 */
public interface DirectBot {

    /** Before the first turn. */
    void start(Game game, int player);

    /** One turn: gives the player's commands to the game. An exception is the bot's fault and puts the player out. */
    void turn();

    /** The message that goes with the last commands, or {@code null}. */
    default String message() {
        return null;
    }

    /** The match is over. */
    default void end() { }
}
