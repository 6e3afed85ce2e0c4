/** {@code steward league run}: what is asked, and what is shown while games are played. */
package steward.cli.league.run;
