package steward.game;

import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import steward.physics.Bodies;
import steward.physics.TurnLog;

/**
 * One game in progress. The referee reads each player's command into it through the {@link GameJson}, eliminates
 * players at fault, and plays the turn. Players are numbered from 0. Not thread-safe; deterministic: the same setup,
 * seed, commands and eliminations give the same bits.
 */
public interface Game {

    /** Returns the number of players. */
    int players();

    /** Turns played. */
    int turn();

    /** True if the player is not eliminated. */
    default boolean isIn(int player) {
        return eliminationReason(player) == null;
    }

    /** True if the player is asked for the next turn: here all who are in; a guest's referee names one of them. */
    default boolean isAsked(int player) {
        return isIn(player);
    }

    /** Limit of the player's next answer in milliseconds, where the game sets it; 0 for that of the scene. */
    default int limitMs(int player) {
        return 0;
    }

    /**
     * Time within the limit of the player's next answer after which the game counts it as late, in milliseconds; 0
     * where it counts none.
     */
    default int strikeMs(int player) {
        return 0;
    }

    /** Tells the time that the player took for the answer that is read next, where it counts in the game. */
    default void timed(int player, long nanos) {
        // Times decide nothing in a game that Steward computes.
    }

    /**
     * Returns why a referee of its own has thrown the player out, once the game is over; {@code null} if it has not. It
     * is a fault of the player, but none that eliminated it.
     */
    default String expulsion(int player) {
        return null;
    }

    /** Ends what the game holds beside memory, from any thread; the second call does nothing. */
    default void close() {
        // A game that Steward computes holds nothing.
    }

    /** Returns why the player was eliminated, or {@code null}. */
    String eliminationReason(int player);

    /**
     * Eliminates a player for a reason outside the rules (a fault), as part of the next turn; the game decides what
     * happens to the bodies. Does nothing if the player is already eliminated.
     */
    void eliminate(int player, String reason);

    /**
     * Fewest players with whom a turn is played. If faults leave fewer in, the game ends without playing the turn; 0
     * where every turn is played.
     */
    default int fewestPlayers() {
        return 0;
    }

    /** True if faults have decided the next turn: it is not played, and no further player is asked for it. */
    default boolean isDecided() {
        int in = 0;
        for (int player = 0; player < players(); player++) {
            in += isIn(player) ? 1 : 0;
        }
        return in < fewestPlayers();
    }

    /** Plays one turn with the commands read since the last; eliminated players have none. */
    void play();

    /** True if the game has ended: no further turn may be played. */
    boolean isOver();

    /** The standing, final once over: 0 for the best, players who tie share a rank (0, 1, 1, 3). */
    int[] ranks();

    /**
     * A score per player, in a measure of the game: a better rank never has the lower score, or where
     * {@link #lowerScoreIsBetter} never the higher one.
     */
    double[] scores();

    /**
     * The game's own values beside the score, such as laps or water, by name in alphabetical order: a number for each
     * player. A name is letters of one word.
     */
    default SortedMap<String, double[]> ownValues() {
        return Collections.emptySortedMap();
    }

    /** True if a lower score is better, as where it is a time. */
    default boolean lowerScoreIsBetter() {
        return false;
    }

    /** One sentence that says how the game ended, without its full stop, or {@code null} while it goes on. */
    String ending();

    /** The bodies now. */
    Bodies bodies();

    /** Returns how many bodies are at rest now, or -1 where none can come to rest. */
    default int bodiesAtRest() {
        return -1;
    }

    /** Impacts and path knots of the last turn. */
    TurnLog log();

    /** Births, deaths and marks of the last turn, in order. */
    List<TurnEvent> events();

    /**
     * A game that goes on from this state independently: under the same commands it gives the same bits. To be called
     * between two turns; the impacts and events of the last turn are not copied.
     */
    Game copy();

    /** A 64-bit hash of the full state: two games with the same hash continue alike under the same commands. */
    long hash();
}
