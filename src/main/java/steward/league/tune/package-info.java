/** Tuning: parameters in a bot's command, and how they climb. */
package steward.league.tune;
