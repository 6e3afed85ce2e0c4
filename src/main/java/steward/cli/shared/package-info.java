/** What several commands share: streams and terminals, options, error messages and exit statuses, the list of games. */
@Internal
package steward.cli.shared;

import steward.Internal;
