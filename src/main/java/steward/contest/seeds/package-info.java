/** Seeds of a series of games: consecutive numbers, or a list from a file. */
package steward.contest.seeds;
