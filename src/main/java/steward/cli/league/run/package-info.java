/** {@code steward league run}: what is asked, and what is shown while games are played. */
@Internal
package steward.cli.league.run;

import steward.Internal;
