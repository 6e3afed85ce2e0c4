/**
 * Protocol of the search race: JSON frames and answers, CodinGame's lines. Other packages see the game as {@link
 * steward.game.searchrace.protocol.SearchRaceType}.
 */
package steward.game.searchrace.protocol;
