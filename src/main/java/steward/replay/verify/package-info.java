/**
 * Playing a recorded match again and comparing every turn with what was recorded, to the bit; the first difference is
 * named.
 */
@Internal
package steward.replay.verify;

import steward.Internal;
