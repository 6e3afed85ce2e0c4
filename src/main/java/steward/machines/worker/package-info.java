/** A worker: takes games of a league from its broker, plays them here, and sends what came of them. */
@Internal
package steward.machines.worker;

import steward.Internal;
