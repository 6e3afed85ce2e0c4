package steward.scene;

import steward.physics.Advance;
import steward.physics.PhysicsParts;

/** Hook that sees each advance that a game takes from its plan, and may replace it by another, for measurements. */
@FunctionalInterface
public interface PhysicsObserver {

    /** Changes nothing. */
    PhysicsObserver NONE = (parts, advance) -> advance;

    /**
     * @param advance the advance that the scene requires
     * @return the advance that the game gets
     */
    Advance observe(PhysicsParts parts, Advance advance);
}
