/**
 * Rules of the search race, an optimisation for one player: a car passes checkpoints, and less time is better. Free of
 * JSON and of processes; {@link steward.game.searchrace.OfficialSearchRace} holds the official arithmetic.
 */
package steward.game.searchrace;
