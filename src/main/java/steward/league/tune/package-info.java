/** Tuning: parameters in a bot's command, and how they climb. */
@Internal
package steward.league.tune;

import steward.Internal;
