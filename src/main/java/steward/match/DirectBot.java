package steward.match;

import steward.game.Game;

/**
 * A bot inside this JVM that looks at the game itself instead of reading lines, and gives its commands to it: nothing
 * is written and nothing parsed. A match with such bots gives the same result, and the same recording, as one in which
 * the same commands came as lines.
 *
 * <p>One instance plays one match; the methods are called by one thread at a time. It must not alter the game but by
 * giving commands, for which each game has its own class.
 */
public interface DirectBot {

    /** Before the first turn. */
    void start(Game game, int player);

    /** One turn: gives the player's commands to the game. What it throws is its fault, and the player is out. */
    void turn();

    /** The message that goes with the last commands, or {@code null}. */
    default String message() {
        return null;
    }

    /** The match is over. */
    default void end() {
    }
}
