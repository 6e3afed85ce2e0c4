/**
 * Games whose referee is a program of its own: the blocks that it speaks, its process, and the game that Steward sees.
 * Behind {@link steward.game.Game}, so that nobody above knows; it knows no particular contest.
 */
package steward.guest;
