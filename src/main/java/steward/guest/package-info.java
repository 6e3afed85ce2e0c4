/**
 * Guests, games whose referee is an external program: its blocks of lines, its process, and the game that Steward sees.
 * Behind {@link steward.game.Game} nobody knows that a game is a guest; this package knows no particular contest.
 */
package steward.guest;
