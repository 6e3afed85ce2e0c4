package steward.scene;

import steward.physics.Advance;
import steward.physics.PhysicsParts;

/** Observer of the advances that games take from their plan. It may replace them by its own, for measurements. */
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
