/** Tuning: parameters in a bot's command, and the algorithm that improves them. */
package steward.league.tune;
