package steward.physics;

/**
 * Way to advance that has the bits of a published official referee, which a game brings for the rung {@code
 * event/official}. If a game has none, that rung computes the pod race's expressions under the scene's {@link
 * ImpactLaw}.
 */
@FunctionalInterface
public interface OfficialExpressions {

    /** A way to advance of these parts, in the official arithmetic. One instance serves one thread. */
    Advance of(PhysicsParts parts);
}
