/**
 * Fairness between bots that share a machine. It decides which may compute while others are asked, measures how much
 * they use, and has the connection to the program that stops them. It knows no rules of games and no answers.
 */
package steward.bot.hold;
