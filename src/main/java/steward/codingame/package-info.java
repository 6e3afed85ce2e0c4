/**
 * Formats of the tools around CodinGame: its game result, the fields of a league system, the protocols by which match
 * runners call a referee. The pod race is the only game it knows.
 */
package steward.codingame;
