/** The games of a league in an SQLite file, written, read and exported. Nothing else uses SQLite. */
package steward.league.store;
