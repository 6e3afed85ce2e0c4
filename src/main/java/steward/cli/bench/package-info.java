/**
 * The command {@code bench}, and the contenders for the pod race.
 */
@Internal
package steward.cli.bench;

import steward.Internal;
