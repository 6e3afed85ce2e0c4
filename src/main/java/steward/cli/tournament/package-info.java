/**
 * {@code steward tournament}: a tournament of a class, from a folder of source files to a table, played as a league.
 */
package steward.cli.tournament;
