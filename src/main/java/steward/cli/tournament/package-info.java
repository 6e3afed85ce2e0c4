/** {@code steward tournament}: a class's evening, from a folder of source files to a table; a league underneath. */
package steward.cli.tournament;
