/** Bots on their way to another machine: their files under the hash of all of them. */
@Internal
package steward.machines.bundle;

import steward.Internal;
