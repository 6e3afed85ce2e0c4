/** {@code steward league run}: its options, and its display while games are played. */
package steward.cli.league.run;
