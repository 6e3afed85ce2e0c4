/**
 * The sections of the bench: matches, frames, crowds, processes, start-up, verification, growth.
 */
@Internal
package steward.bench.section;

import steward.Internal;
