package steward.replay;

import tools.jackson.core.JsonGenerator;

/**
 * Observations of a match by another referee. A replay that keeps it in place of our own outcomes is marked as
 * imported: its verification compares everything that was observed, and passes over what was not. Each method adds
 * fields to an object that the caller opens and closes.
 */
public interface Observations {

    /** True if the state before the first turn was observed; otherwise the one that follows from the scene is kept. */
    boolean hasStart();

    /** Fields of the state before the first turn, in the form of {@link steward.game.StateCodec#writeState}. */
    void writeStart(JsonGenerator out);

    /**
     * Fields of a turn's outcome, in the form of a recorded outcome.
     *
     * @param turn counted from 1
     */
    void writeOutcome(JsonGenerator out, int turn);

    /** A player's rank as observed, or -1: then ours is kept. */
    int rank(int player);

    /** A player's final score as observed, or NaN: then ours is kept. */
    default double score(int player) {
        return Double.NaN;
    }
}
