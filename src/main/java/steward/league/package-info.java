/**
 * A league on disk: the file that a person edits, the folder, identities of bots and games, and the schedule. It
 * computes nothing from results and stores nothing.
 */
package steward.league;
