/**
 * Watching a match while it is played: its lines kept for everybody who looks on, a small server on this machine that
 * hands them to browsers, and the browser itself. Whoever watches, however slowly, never holds the match up.
 */
@Internal
package steward.live;

import steward.Internal;
