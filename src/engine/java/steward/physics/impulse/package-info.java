/** Impulse and reaction in every arithmetic: velocities, separation, positional correction, rest of heaps. */
package steward.physics.impulse;
