package steward.scene;

import steward.Internal;
import steward.physics.Advance;
import steward.physics.PhysicsParts;

/** Sees the ways to advance that games take from their plan, and may put its own in their place: for measuring. */
@FunctionalInterface
@Internal
public interface PhysicsObserver {

    /** Sees nothing and changes nothing. */
    PhysicsObserver NOBODY = (parts, advance) -> advance;

    /**
     * @param parts   what it is made of
     * @param advance the way to advance that the scene asks for
     * @return what the game gets
     */
    Advance observe(PhysicsParts parts, Advance advance);
}
