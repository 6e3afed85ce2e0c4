/** The commands of {@code steward league}, and what they print. */
@Internal
package steward.cli.league;

import steward.Internal;
