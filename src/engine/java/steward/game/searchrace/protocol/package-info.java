/** Protocol of the search race: JSON frames and answers, CodinGame's lines. */
package steward.game.searchrace.protocol;
