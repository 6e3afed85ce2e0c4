/**
 * The command {@code bench}, and the contenders for the pod race.
 */
@Internal
package steward.lab.cli.bench;

import steward.Internal;
