/** Pairing that learns from results, and rules that end a league when enough is known. */
@Internal
package steward.league.pairing;

import steward.Internal;
