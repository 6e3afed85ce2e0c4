/**
 * Attacked on purpose: hostile bots at every level of isolation, referees that are killed at random moments, and
 * thousands of matches in one JVM. Each is a program of its own, run in full by a Gradle task ({@code hostile},
 * {@code killed}, {@code soak}) and in a short form by a test.
 */
package steward.hostile;
