package steward.game;

/**
 * Event of a turn other than an impact, for people: it is kept in the replay and drawn.
 *
 * @param time     within the turn, 0..1
 * @param body     id of the body concerned, or -1
 * @param x        where, in u
 * @param y        where, in u
 * @param text     a few words, such as {@code "lap 2 of 3"}; may be empty
 * @param headline whether it gets a line of its own while a match is watched
 */
public record TurnEvent(Kind kind, double time, int body, double x, double y, String text, boolean headline) {

    /** Kinds of events. */
    public enum Kind {
        /** A body was added. */
        BIRTH,
        /** A body was removed. */
        DEATH,
        /** Any other event worth showing. */
        MARK
    }
}
