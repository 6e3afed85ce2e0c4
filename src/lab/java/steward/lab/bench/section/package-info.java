/**
 * The sections of the bench: matches, frames, crowds, processes, start-up, verification, growth.
 */
@Internal
package steward.lab.bench.section;

import steward.Internal;
