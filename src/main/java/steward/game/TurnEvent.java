package steward.game;

/**
 * Something that a turn brought besides impacts, for people to see; it is kept in the replay and drawn.
 *
 * @param kind     what it is
 * @param time     within the turn, 0..1
 * @param body     id of the body concerned, or -1
 * @param x        where, in u
 * @param y        where, in u
 * @param text     a few words, such as {@code "lap 2 of 3"}; may be empty
 * @param headline whether it is worth a line of its own while a match is watched
 */
public record TurnEvent(Kind kind, double time, int body, double x, double y, String text, boolean headline) {

    /** Kinds of events. */
    public enum Kind {
        /** A body came into being. */
        BIRTH,
        /** A body is gone. */
        DEATH,
        /** Anything else worth showing. */
        MARK
    }
}
