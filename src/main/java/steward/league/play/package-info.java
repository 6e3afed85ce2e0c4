/**
 * A league while it is played: which program each bot is at the moment, the games on their threads, and what is told
 * of them. It knows games only through contests, and does not use the terminal.
 */
package steward.league.play;
