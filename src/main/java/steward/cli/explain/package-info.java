/** The command {@code explain}: parts of a scene and their prices. */
@Internal
package steward.cli.explain;

import steward.Internal;
