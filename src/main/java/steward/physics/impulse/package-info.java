/**
 * What an impact does: the impulse under a law, the velocities after it, separation, and positional correction, in
 * every arithmetic; and {@link steward.physics.impulse.Touch}, which answers a contact by an impulse, a passage or a
 * question.
 */
@Internal
package steward.physics.impulse;

import steward.Internal;
