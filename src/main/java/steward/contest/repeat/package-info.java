/** Games that only repeat earlier ones: if bots play alike whatever the seed is, more games give no information. */
package steward.contest.repeat;
