/** Seeds of a series of games: numbers in a row, or those that a file lists. */
package steward.contest.seeds;
