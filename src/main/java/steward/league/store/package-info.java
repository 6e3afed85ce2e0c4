/**
 * Storage of a league's games in an SQLite file. It holds the schema and its upgrade, writing in the order of arrival,
 * reading of sums and lists, and files for other programs. Nothing else in the program uses SQLite.
 */
package steward.league.store;
