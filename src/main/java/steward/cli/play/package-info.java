/**
 * Commands that play matches ({@code match}, {@code play}, {@code referee}, {@code demo}, {@code simulate}, {@code
 * run}) and {@code scene}, which lists and prints the scenes that can be played.
 */
package steward.cli.play;
