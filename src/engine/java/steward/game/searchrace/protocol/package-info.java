/**
 * Protocol of the search race: JSON frames and answers, CodinGame's lines; and {@link
 * steward.game.searchrace.protocol.SearchRaceType}, the game as the other rooms see it.
 */
package steward.game.searchrace.protocol;
