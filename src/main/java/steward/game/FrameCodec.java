package steward.game;

import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/**
 * JSON of one game: the frames and answers of players, and what a replay keeps. Bound to one {@link Game}; the
 * {@code write} methods add fields to an object that the caller has opened and closes. Numbers go through
 * {@link JsonNumbers}.
 */
public interface FrameCodec {

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
     * Fields of the full state. One of them is {@code bodies}: an array with one object for every body that can move,
     * each with at least {@code id}, {@code x} and {@code y}, which every viewer draws.
     */
    void writeState(JsonGenerator out);

    /**
     * Fields that say what to draw, constant over the game: {@code field} (x, y, width, height), {@code walls},
     * {@code zones} (x, y, radius, label) and {@code bodies} (id, radius, owner, kind, label).
     */
    void writeDrawing(JsonGenerator out);
}
