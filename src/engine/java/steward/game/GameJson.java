package steward.game;

import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/**
 * JSON of one {@link Game}, all of it written and read: frames and answers, commands and states, the drawing. A replay
 * keeps commands and states complete and in full precision. The {@code write} methods, all but {@link #writeCommand},
 * add fields to an object that the caller has opened and closes; numbers go through {@link JsonNumbers}.
 *
 * <p>In some games the part of a faulty answer before its fault takes effect all the same, such as the lines before a
 * bad one. The part that was read then is a partial command.
 */
public interface GameJson {

    /** Fields of the player's setup frame, beyond those every game has (type, game, player, players, time). */
    void writeSetup(JsonGenerator out, int player);

    /** Fields of the player's turn frame, beyond those every game has (type, turn). */
    void writeTurn(JsonGenerator out, int player);

    /**
     * Reads a player's answer to a turn frame and, if it is valid, makes it the player's command.
     *
     * @param line   UTF-8, without line end
     * @param length how many bytes count
     * @return {@code null} if it is valid; otherwise what is wrong: field, value found, what was expected
     */
    String readAnswer(int player, byte[] line, int length);

    /** The message that came with the player's last answer, or {@code null}. */
    String message(int player);

    /** One value: the player's command as it is about to be played, complete and in full precision. */
    void writeCommand(JsonGenerator out, int player);

    /**
     * The inverse of {@link #writeCommand}; the parser stands on the first token of the value.
     *
     * @return {@code null} if it is valid; otherwise what is wrong, as {@link #readAnswer}
     */
    String readCommand(JsonParser in, int player);

    /**
     * A faster {@link #readCommand}, for commands that are written as {@link #writeCommand} usually writes them.
     * Commands that it accepts are read to the bit; it may reject anything.
     *
     * @param json where the value begins at {@code from} and ends before {@code to}
     * @return the place behind the value; or -1 if another reader has to be asked: then no command has changed
     */
    default int readPlainCommand(byte[] json, int from, int to, int player) {
        return -1;
    }

    /**
     * True if a faulty answer has given the player commands before its fault, which take effect all the same; {@link
     * #writeCommand} then writes them.
     */
    default boolean hasPartialCommand(int player) {
        return false;
    }

    /** Takes back what commands were read for a player since the last turn. */
    default void clearCommand(int player) { }

    /** As {@link #readCommand}, of what a faulty answer has given before its fault. */
    default String readPartialCommand(JsonParser in, int player) {
        return "found a command of a player who failed, expected null";
    }

    /**
     * Fields of the full state. One of them is {@code bodies}: an array with one object for every body that can move,
     * each with at least {@code id}, {@code x} and {@code y}, which every viewer draws.
     */
    void writeState(JsonGenerator out);

    /**
     * Fields of a turn's outcome that not every game has, in this order: {@code zones} that are there after this turn,
     * as in the drawing; {@code scores}, a number per player; {@code resources}, an object of numbers per player. They
     * are to be shown; what the game needs to go on stands in its state.
     */
    default void writeProgress(JsonGenerator out) {
        // Most games tell all by their bodies.
    }

    /**
     * Fields that say what to draw, constant over the game: {@code field} (x, y, width, height), {@code walls}, {@code
     * zones} (x, y, radius, label) and {@code bodies} (id, radius, owner, kind, label); see {@link DrawingJson}.
     */
    void writeDrawing(JsonGenerator out);
}
