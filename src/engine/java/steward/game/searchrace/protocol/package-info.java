/**
 * What bots of the search race read and write: JSON frames and answers, CodinGame's lines; and
 * {@link steward.game.searchrace.protocol.SearchRaceType}, the game as the other rooms see it.
 */
@Internal
package steward.game.searchrace.protocol;

import steward.Internal;
