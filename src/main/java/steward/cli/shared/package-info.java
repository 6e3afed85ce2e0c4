/**
 * What several commands share: streams and terminals, messages of errors and their exit status, the list of games.
 */
@Internal
package steward.cli.shared;

import steward.Internal;
