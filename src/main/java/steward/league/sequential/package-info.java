/** Tests that stop: the generalized sequential probability ratio test, and what it is to be expected to cost. */
@Internal
package steward.league.sequential;

import steward.Internal;
