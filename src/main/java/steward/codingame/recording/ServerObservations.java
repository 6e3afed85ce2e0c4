package steward.codingame.recording;

import steward.game.Game;
import steward.replay.Observations;

/** Observations of a match by a server whose answers are played again, and how far they go. */
interface ServerObservations extends Observations {

    /** Returns how many turns were recorded. */
    int turns();

    /** True if no player said anything in a turn, counted from 1. */
    boolean isSilent(int turn);

    /** True if the server has ended the game: it says who has won. */
    boolean isOver();

    /** Passes the game as we play it, before its first turn. */
    default void start(Game game) {
        // Most servers show all that is kept.
    }
}
