/**
 * The games of a league in an SQLite file: its schema and how it is brought up to date, writing in the order of
 * arrival, reading sums and lists, files for other programs. Nothing else in the program uses SQLite.
 */
package steward.league.store;
