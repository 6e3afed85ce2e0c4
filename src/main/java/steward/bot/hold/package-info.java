/**
 * Fairness between bots that share a machine: who may compute while others are asked, what such bots use, and the
 * connection to the program that stops them. Knows no rules of games and no answers.
 */
package steward.bot.hold;
