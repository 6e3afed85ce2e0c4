/** Commands that show a league: its table, page and games. */
package steward.cli.league.view;
