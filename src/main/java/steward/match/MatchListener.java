package steward.match;

import steward.game.FrameCodec;
import steward.game.Game;

/** Who follows a match as it is played. Called in order by one thread at a time. */
public interface MatchListener {

    /** Before the first turn; the game and its codec may be looked at in every later call, never altered. */
    default void start(Game game, FrameCodec codec) {
    }

    /** All players have been asked, faults are counted; the turn is about to be played. */
    default void commands(Turn turn) {
    }

    /** The turn has been played. */
    default void played(Turn turn) {
    }

    /** The match has its result. */
    default void end(MatchResult result) {
    }
}
