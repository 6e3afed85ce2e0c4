package steward.game;

import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;

/**
 * Reads a game's part of the views in recordings of the site's server, for {@code steward import}. A view is that of
 * one kind of game; everything else in a recording is the same for all.
 *
 * <p>An imported turn holds what was shown, as fields of a recorded outcome, in their order; what was not shown is left
 * out. {@link #writeShown} writes the same of a turn of ours, with the same rounding, and may write more: verification
 * compares the fields that were recorded.
 */
public interface ServerView {

    /** Name of the game as the site's server shows it. */
    String title();

    /** True if a recording with this first view is of this game: where the views tell, its line 1 is the title. */
    default boolean isOf(ViewLines first) {
        return first.line(1).strip().equals(title());
    }

    /**
     * Reads how a game begins.
     *
     * @param first   the view of frame 0
     * @param input   what the server's referee was given, field {@code refereeInput}; empty if that is not recorded
     * @param players how many players the frames are of
     * @throws IllegalArgumentException if anything about it is wrong: names the line, what was found and was expected
     */
    Shown open(ViewLines first, String input, int players);

    /**
     * Fields of the outcome of the turn just played, as the server would have shown it.
     *
     * @param state the codec of the game
     */
    void writeShown(JsonGenerator out, Game game, StateCodec state);

    /** Fields of the state before the first turn, as the server shows it: where it rounds the start too, rounded. */
    default void writeShownStart(JsonGenerator out, Game game, StateCodec state) {
        state.writeState(out);
    }

    /** One recorded game. */
    interface Shown {

        /** Its scene, as JSON. */
        String scene();

        long seed();

        /**
         * Adds the view of the next turn.
         *
         * @param view that of the frame that ends the turn; without lines if it has none
         * @throws IllegalArgumentException if anything about it is wrong: names the line
         */
        void add(ViewLines view);

        /** Fields of the state before the first turn. */
        void writeStart(JsonGenerator out);

        /**
         * Fields of the outcome of a turn.
         *
         * @param turn counted from 1, at most as many as were added
         */
        void writeOutcome(JsonGenerator out, int turn);

        /**
         * Final score of a player; not finite if it is not recorded.
         *
         * @param scores as they stand beside the frames; empty if not recorded
         */
        default double score(int player, double... scores) {
            return scores.length == 0 ? Double.NaN : scores[player];
        }

        /**
         * One line of the answer of a player that the server did not ask any more in the turn in which the game ended:
         * it should have no effect.
         */
        default String idle() {
            return "WAIT";
        }
    }
}
