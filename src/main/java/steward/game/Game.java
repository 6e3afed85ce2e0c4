package steward.game;

import java.util.List;
import steward.physics.Bodies;
import steward.physics.TurnLog;

/**
 * One game in progress. The referee has each player's command read into it by the {@link FrameCodec}, eliminates who
 * failed, and plays the turn. Players are numbered from 0. Not thread-safe; deterministic: same setup, seed, commands
 * and eliminations, same bits.
 */
public interface Game {

    /** How many players there are. */
    int players();

    /** Turns played. */
    int turn();

    /** Whether the player is still in. */
    default boolean isIn(int player) {
        return eliminationReason(player) == null;
    }

    /** Why the player is out, or {@code null} while in. */
    String eliminationReason(int player);

    /**
     * Takes a player out for a reason from outside (a fault), as part of the turn that is about to be played; the
     * game decides what becomes of the bodies. Does nothing if the player is out already.
     */
    void eliminate(int player, String reason);

    /** Plays one turn with the commands read since the last; players who are out have none. */
    void play();

    /** Whether a result is reached: no further turn may be played. */
    boolean isOver();

    /** The standing, final once over: 0 for the best, players who tie share a rank (0, 1, 1, 3). */
    int[] ranks();

    /** A number per player in a measure of the game's: a better rank never has the lower score. */
    double[] scores();

    /** One sentence that says how the game ended, without its full stop, or {@code null} while it goes on. */
    String ending();

    /** The bodies now. */
    Bodies bodies();

    /** Impacts and path knots of the last turn. */
    TurnLog log();

    /** Births, deaths and marks of the last turn, in order. */
    List<TurnEvent> events();

    /** A 64-bit hash of the full state: two games with the same hash go on alike under the same commands. */
    long hash();
}
