/**
 * The command {@code bench}, and the contenders that know the pod race.
 */
@Internal
package steward.cli.bench;

import steward.Internal;
