/** A league as one page, as JSON and as plots. */
@Internal
package steward.league.page;

import steward.Internal;
