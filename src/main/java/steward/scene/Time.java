package steward.scene;

/**
 * How long a player may take.
 *
 * @param firstAnswerMs for the first answer, its start included, in milliseconds
 * @param answerMs      for every later answer, in milliseconds
 */
public record Time(int firstAnswerMs, int answerMs) {
}
