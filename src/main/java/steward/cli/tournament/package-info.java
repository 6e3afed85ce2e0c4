/** {@code steward tournament}: a class's evening, from a folder of source files to a table; a league underneath. */
@Internal
package steward.cli.tournament;

import steward.Internal;
