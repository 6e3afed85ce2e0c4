/**
 * Common parts of several commands: streams and terminals, messages of errors and their exit status, the list of games.
 */
@Internal
package steward.cli.shared;

import steward.Internal;
