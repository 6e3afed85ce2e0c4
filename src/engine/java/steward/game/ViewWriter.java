package steward.game;

import java.util.List;
import steward.scene.Scene;

/**
 * Writer of the views and summaries that the site's server would have shown of a game of ours, frame by frame.
 * Verification compares them word by word with the recorded ones.
 *
 * <p>The word {@link #ANY} in a line stands for one word that is not compared, and {@link #REST} for all words from
 * there to the end of the line; as the last line it stands for any lines. A word that begins with {@link #NEAR} is a
 * number that need only be near to the recorded one. Line 0 of a view holds its number, which the import has checked.
 *
 * <p>Calls: {@link #observed}, {@link #begin}, {@link #start}, then for each turn {@link #before} and {@link #after}.
 */
public interface ViewWriter {

    /** Fault of a player of whom a recording has no answer. */
    String NO_ANSWER = "no answer in the recording";
    /** One word that is not compared. */
    String ANY = "*";
    /** Words, or none, that are not compared, up to the end of the line. */
    String REST = "**";
    /** View of which nothing is compared but its number. */
    List<String> UNKNOWN = List.of(ANY + " " + REST, REST);
    /** Beginning of a word that is a number within 1e-9 of the recorded one; no message holds this character. */
    String NEAR = "\u0001";

    /**
     * A frame. Of what is {@code null} it is not known what the server shows, and it is not compared.
     *
     * @param view        its lines; line 0 is the number, and what the server says behind it
     * @param summary     its lines
     * @param information lines for people about the answer of the frame
     * @param tooltips    of the frame, a line for each, which begins with its player
     */
    record Frame(List<String> view, List<String> summary, List<String> information, List<String> tooltips) {

        public Frame(List<String> view, List<String> summary) {
            this(view, summary, null, null);
        }
    }

    /** Words for people where {@link #ANY} and {@link #REST} stand; each a plural. */
    List<String> notCompared();

    /** Lines of a recorded view as they are compared: where its order is not fixed, in a fixed order. */
    default List<String> lines(String text) {
        return List.of(text.split("\r?\n", -1));
    }

    /** The scene with an observer, where a view shows more of a turn than the game keeps. */
    default Scene observed(Scene scene) {
        return scene;
    }

    /** Takes the game, before its first turn. */
    void begin(Game game);

    /** True if texts are compared as they stand, and no word in them has a meaning of its own. */
    default boolean isVerbatim() {
        return false;
    }

    /** Number of frames of the turn just played, or of the start, where only the game tells it; otherwise 0. */
    default int frames() {
        return 0;
    }

    /** Last frame of the start. */
    Frame start();

    /** Keeps what the turn that is about to be played changes; its commands are read. */
    void before();

    /**
     * The frame of an answer that does not end the turn; asked for before {@link #after}.
     *
     * @param answer counted from 0 in each turn
     */
    default Frame answer(int answer) {
        return new Frame(List.of(ANY + " " + REST), null);
    }

    /**
     * The frame that ends the turn just played.
     *
     * @param messages per player what was said in this turn, joined, or {@code null}
     * @param shown    the lines of the recorded view, of which nothing but the place of the messages is taken
     */
    Frame after(String[] messages, List<String> shown);

    /** The view of a frame behind the end of the game, in which nobody is asked; {@link #UNKNOWN} counts it only. */
    default List<String> declared() {
        return UNKNOWN;
    }

    /** True if a source may leave out all lines of a view from this one on. */
    default boolean mayEndAt(int line) {
        return false;
    }

    /**
     * The final score of each player as the server tells it; {@code null} where that is the game's own, empty where it
     * is not known what the server's says.
     */
    default double[] scores() {
        return null;
    }

    /** Lines of what the server's referee says at the end that it was given; {@code null} if it is not compared. */
    default List<String> input() {
        return null;
    }

    /** Lines of values at the end for those who evaluate games; {@code null} if they are not compared. */
    default List<String> metadata() {
        return null;
    }
}
