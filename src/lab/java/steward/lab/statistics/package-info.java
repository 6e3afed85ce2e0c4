/** Checks of ratings, tests and pairings by leagues of made-up bots whose strengths are known. */
package steward.lab.statistics;
