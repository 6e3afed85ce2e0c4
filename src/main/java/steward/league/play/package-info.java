/** A league while it is played: its bots at the moment, the games on their threads, and what is told of them. */
package steward.league.play;
