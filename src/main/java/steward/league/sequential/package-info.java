/** Tests that stop: the generalized sequential probability ratio test, and what it is to be expected to cost. */
package steward.league.sequential;
