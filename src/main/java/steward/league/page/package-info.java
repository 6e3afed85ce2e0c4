/** A league as one page, as JSON and as plots. */
package steward.league.page;
