/** Ratings of bots, from the games that were stored and nothing else: sums, a joint fit of all games, tables. */
package steward.league.rating;
