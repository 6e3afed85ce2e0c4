package steward.game;

import tools.jackson.core.JsonGenerator;

/** The frames of one {@link Game} that players are sent, and their answers, as JSON. */
public interface BotFrames {

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
}
