/**
 * Measurement of the time that bot processes use, as Linux shows it under {@code /proc}: CPU time, waiting for a
 * processor, and whether a thread sleeps. Nothing here runs in a turn that is answered at once.
 */
package steward.bot.accounting;
