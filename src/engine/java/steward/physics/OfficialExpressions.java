package steward.physics;

/**
 * A published official referee's own arithmetic, which a game brings for the rung {@code event/official}: a way to
 * advance whose turns have that referee's bits. Where a game has none, that rung computes the pod race's expressions
 * under the scene's {@link ImpactLaw}.
 */
@FunctionalInterface
public interface OfficialExpressions {

    /** A way to advance of these parts, in the official arithmetic. One instance serves one thread. */
    Advance of(PhysicsParts parts);
}
