/**
 * Impulse and reaction: the impulse under a law, the velocities after it, separation, and positional correction, in
 * every arithmetic; and {@link steward.physics.impulse.ContactResponse}, which responds to a contact with an impulse,
 * lets the pair pass, or asks the scene's reaction.
 */
package steward.physics.impulse;
