/**
 * Impulses in every arithmetic: the impulse under a law, the velocities after it, separation, and positional
 * correction. {@link steward.physics.impulse.ContactResponse} responds to a contact with an impulse, lets the pair
 * pass, or asks the scene's reaction.
 */
package steward.physics.impulse;
