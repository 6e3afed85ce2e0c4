/** Isolation of a bot's processes from all others: levels, what this machine offers, and programs started so. */
package steward.bot.isolation;
