/** Rules of the search race, free of JSON: a car passes checkpoints, one player, and less time is better. */
package steward.game.searchrace;
