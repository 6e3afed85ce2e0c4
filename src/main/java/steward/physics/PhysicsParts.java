package steward.physics;

import java.util.List;

/**
 * The parts of a scene's physics. An advance is built from these; what is not among them costs nothing during a turn.
 *
 * @param law            the law of impact
 * @param arithmetic     how times of impact are computed
 * @param contacts       what contacts mean
 * @param walls          immovable walls, each identified by its index in this list; may be empty
 * @param reaction       answers {@code ASK} contacts, or {@code null} if there are none
 * @param infiniteMasses whether bodies can have infinite mass: two of them never exchange an impulse
 */
public record PhysicsParts(ImpactLaw law, Arithmetic arithmetic, Contacts contacts, List<Wall> walls,
                           Reaction reaction, boolean infiniteMasses) {

    /**
     * @throws IllegalArgumentException if there is an {@code ASK} contact without a reaction, or a reaction without one
     */
    public PhysicsParts {
        walls = List.copyOf(walls);
        if (contacts.containsAsk() != (reaction != null)) {
            throw new IllegalArgumentException(reaction == null
                ? "contacts ask, but there is no reaction" : "there is a reaction, but no contact asks");
        }
    }

    /** One kind of bodies with finite masses that bounce off each other, without walls. */
    public PhysicsParts(ImpactLaw law, Arithmetic arithmetic) {
        this(law, arithmetic, new Contacts(1), List.of(), null, false);
    }
}
