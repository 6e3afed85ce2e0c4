/** Fairness between bots on one machine: who may compute while others are asked, and what stops the rest. */
package steward.bot.hold;
