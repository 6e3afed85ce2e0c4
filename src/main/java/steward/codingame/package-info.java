/** Formats of the tools around CodinGame: its game result, a league system's fields, calls of a referee. */
package steward.codingame;
