/**
 * Playing a league: which program each bot is at the moment, games on threads, and reports on them. It knows games only
 * through contests, and does not use the terminal.
 */
package steward.league.play;
