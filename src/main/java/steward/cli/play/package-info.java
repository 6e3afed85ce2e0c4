/** Commands that play matches, and {@code scene}, which lists and prints what can be played. */
package steward.cli.play;
