package steward.physics;

import java.util.List;

/**
 * Parts of a scene's physics from which an advance is built. A part that is missing costs nothing during a turn.
 *
 * @param arithmetic     how times of impact are computed
 * @param walls          immovable walls, each identified by its index in this list; may be empty
 * @param reaction       answers {@code ASK} contacts, or {@code null} if there are none
 * @param infiniteMasses whether bodies can have infinite mass: two of them never exchange an impulse
 * @param official       the game's own way to advance in the official arithmetic, or {@code null} if it has none
 * @param forces         what accelerates bodies all the time
 */
public record PhysicsParts(ImpactLaw law, Arithmetic arithmetic, Contacts contacts, List<Wall> walls,
                           Reaction reaction, boolean infiniteMasses, OfficialExpressions official, Forces forces) {

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

    /** Parts of a game without expressions of its own. */
    public PhysicsParts(ImpactLaw law, Arithmetic arithmetic, Contacts contacts, List<Wall> walls, Reaction reaction,
                        boolean infiniteMasses) {
        this(law, arithmetic, contacts, walls, reaction, infiniteMasses, null, Forces.NONE);
    }

    /** One kind of bodies with finite masses that bounce off each other, without walls. */
    public PhysicsParts(ImpactLaw law, Arithmetic arithmetic) {
        this(law, arithmetic, new Contacts(1), List.of(), null, false);
    }

    public PhysicsParts withArithmetic(Arithmetic other) {
        return new PhysicsParts(law, other, contacts, walls, reaction, infiniteMasses, official, forces);
    }

    public PhysicsParts withForces(Forces other) {
        return new PhysicsParts(law, arithmetic, contacts, walls, reaction, infiniteMasses, official, other);
    }

    /** True if a turn from impact to impact is the game's own way to advance. */
    public boolean usesExpressionsOfGame() {
        return official != null && arithmetic.isOfficial();
    }
}
