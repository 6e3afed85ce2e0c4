/** A league on disk: settings, folder, identities of bots and games, and the schedule of who plays whom. */
package steward.league;
