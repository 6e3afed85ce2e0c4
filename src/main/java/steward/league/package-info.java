/**
 * A league on disk: the file that a person edits, the folder, the identity of a bot and of a game, and the schedule of
 * who plays whom. It computes nothing from results and stores nothing.
 */
package steward.league;
