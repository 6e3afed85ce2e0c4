package steward.match;

import steward.game.Game;
import steward.game.GameJson;

/** Observer of a match as it is played. Its methods are called in order, by one thread at a time. */
public interface MatchListener {

    /** Before the first turn; the game and its codec may be read in every later call, never changed. */
    default void start(Game game, GameJson codec) { }

    /** All players have been asked and faults are recorded; the turn is about to be played. */
    default void commands(Turn turn) { }

    /** The turn has been played. */
    default void played(Turn turn) { }

    /** The match has its result. */
    default void end(MatchResult result) { }
}
