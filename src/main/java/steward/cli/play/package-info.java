/**
 * Commands that play matches: {@code match}, {@code play}, {@code referee}, {@code demo}, {@code simulate}; and
 * {@code scene}, which lists and prints what can be played.
 */
package steward.cli.play;
