package steward.scene;

/**
 * Time limits of a player.
 *
 * @param firstAnswerMs for the first answer, its start included, in milliseconds
 * @param answerMs      for every later answer, in milliseconds
 */
public record Time(int firstAnswerMs, int answerMs) { }
