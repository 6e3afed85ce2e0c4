/**
 * A replay as one self-contained page that a browser draws.
 */
@Internal
package steward.replay.page;

import steward.Internal;
