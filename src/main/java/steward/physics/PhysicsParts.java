package steward.physics;

import java.util.List;

/**
 * What the physics of a scene consists of: an advance is put together from these parts, and what is not among them is
 * not looked at during a turn.
 *
 * @param law            how impacts go
 * @param arithmetic     with how much care times of impact are computed
 * @param contacts       what contacts mean
 * @param walls          immovable walls, each named by its place in this list; may be empty
 * @param reaction       answers the contacts that ask, or {@code null} when none does
 * @param infiniteMasses whether bodies can have infinite mass: two of them never exchange an impulse
 */
public record PhysicsParts(ImpactLaw law, Arithmetic arithmetic, Contacts contacts, List<Wall> walls,
                           Reaction reaction, boolean infiniteMasses) {

    /** @throws IllegalArgumentException if a contact asks and there is no reaction, or the other way round */
    public PhysicsParts {
        walls = List.copyOf(walls);
        if (contacts.ask() != (reaction != null)) {
            throw new IllegalArgumentException(reaction == null
                ? "contacts ask, but there is no reaction" : "there is a reaction, but no contact asks");
        }
    }

    /** One kind of bodies with finite masses that bounce off each other, without walls. */
    public PhysicsParts(ImpactLaw law, Arithmetic arithmetic) {
        this(law, arithmetic, new Contacts(1), List.of(), null, false);
    }
}
