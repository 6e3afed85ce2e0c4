/** The league's side of games that are played elsewhere: jobs, workers, and what becomes of what they say. */
@Internal
package steward.machines.serve;

import steward.Internal;
