package steward.game;

/**
 * Line protocol of words and numbers between a game and a player, for games and scenes that have one. It belongs to one
 * {@link Game}, beside its {@link GameJson}. Lines end with a line feed.
 */
public interface TextCodec {

    /** Appends the lines a player is sent before the first turn; none in some protocols. */
    void writeSetup(StringBuilder out, int player);

    /** Appends the lines of one turn. */
    void writeTurn(StringBuilder out, int player);

    /** The number of lines of the player's answer to a turn, at least 1. */
    int answerLines(int player);

    /**
     * Reads a player's answer and, if it is valid, makes it the player's command.
     *
     * @param answer UTF-8, {@link #answerLines} lines separated by line feeds
     * @param length how many bytes count
     * @return {@code null} if it is valid; otherwise what is wrong: line, value found, what was expected
     */
    String readAnswer(int player, byte[] answer, int length);

    /** The messages that came with the player's last answer, joined, or {@code null}. */
    String message(int player);
}
