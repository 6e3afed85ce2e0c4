/** Pairing that learns from results, and rules that end a league when enough is known. */
package steward.league.pairing;
