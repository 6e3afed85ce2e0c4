/** Ratings of bots, computed from stored games alone: sums, a joint fit of all games, tables. */
package steward.league.rating;
