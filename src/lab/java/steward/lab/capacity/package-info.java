/** What workers cost the league's process, measured; and how many it could serve, simulated in virtual time. */
@Internal
package steward.lab.capacity;

import steward.Internal;
