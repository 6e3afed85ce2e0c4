package steward.scene;

import steward.physics.Advance;
import steward.physics.PhysicsParts;

/** Sees the ways to advance that games take from their plan, and may put its own in their place: for measuring. */
@FunctionalInterface
public interface Onlooker {

    /** Sees nothing and changes nothing. */
    Onlooker NOBODY = (parts, advance) -> advance;

    /**
     * @param parts   what it is made of
     * @param advance the way to advance that the scene asks for
     * @return what the game gets
     */
    Advance look(PhysicsParts parts, Advance advance);
}
