/** Neighbours by all pairs: a row of the table of pairs for each body, for the few bodies of a game. */
package steward.physics.event.pairs;
