/** Neighbours by all pairs, for the few bodies of a game: a row of the table of pairs for each body. */
package steward.physics.event.pairs;
