/** Games that only repeat earlier ones: bots that play alike whatever the seed is tell nothing more by them. */
package steward.contest.repeat;
