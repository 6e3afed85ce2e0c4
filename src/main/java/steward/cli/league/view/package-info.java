/** Commands that show a league: its table, page and games, and how they open it. */
package steward.cli.league.view;
