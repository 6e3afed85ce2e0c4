/** Use of time by bot processes, as Linux shows it under {@code /proc}; nothing of it in turns answered at once. */
package steward.bot.accounting;
