/** Sequential tests: the generalized sequential probability ratio test, and its expected length. */
package steward.league.sequential;
