package steward.game.meanmax;

import java.util.List;
import steward.physics.Bodies;
import steward.physics.Motion;

/**
 * End of a turn in Mean Max: rounded positions, and speeds with the friction of their kind. Positions are rounded
 * first. Then speeds lose friction, but not in oil (as seen from the rounded place), and are rounded; all halves away
 * from zero.
 */
public final class OilMotion extends Motion {

    /** The steps outside oil. */
    public OilMotion() {
        super(List.of(Step.ROUND_POSITION_AWAY, Step.DRAG, Step.ROUND_VELOCITY));
    }

    void endTurn(Bodies bodies, MeanMaxWorld world) {
        apply(Of.POSITION, bodies);
        for (int unit = 0; unit < bodies.size(); unit++) {
            bodies.drag[unit] = world.isInOil(unit) ? 0 : UnitKind.of(bodies.kind[unit]).friction();
        }
        apply(Of.DRAG, bodies);
        apply(Of.VELOCITY, bodies);
    }
}
