/** Output of a league: one page, JSON and plots. */
package steward.league.page;
