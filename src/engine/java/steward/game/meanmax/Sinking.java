package steward.game.meanmax;

import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.Reaction;
import steward.physics.TurnSink;

/**
 * Reaction of a tanker that a destroyer touches: the tanker sinks, unless tar has made it heavy. If it sinks inside the
 * arena, its wreck takes an id. Reads and alters the bodies alone; the rest are facts.
 */
public final class Sinking implements Reaction {

    /**
     * Fact: a tanker (id a) was sunk by a destroyer (id b) at (x, y); p is the player it was spawned for, q its size.
     */
    public static final int SUNK = 0;
    /** Fact: it left a wreck (id b) at (x, y), rounded, with water p and radius q. */
    public static final int WRECK = 1;

    /** From this mass on a tanker bounces. */
    static final double HEAVY = 10;

    @Override
    public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
        int tanker = bodies.kind[a] == UnitKind.TANKER.ordinal() ? a : b;
        int destroyer = tanker == a ? b : a;
        if (bodies.mass[tanker] >= HEAVY) {
            return Verdict.BOUNCE;
        }
        double x = bodies.x[tanker];
        double y = bodies.y[tanker];
        int id = bodies.id(tanker);
        sink.fact(time, SUNK, id, bodies.id(destroyer), x, y, bodies.columns[MeanMaxWorld.OWNER][tanker],
            bodies.columns[MeanMaxWorld.SIZE][tanker]);
        if (Math.sqrt(x * x + y * y) < MeanMaxWorld.ARENA_RADIUS) {
            sink.fact(time, WRECK, id, bodies.takeId(), Motion.roundHalfAway(x), Motion.roundHalfAway(y),
                bodies.columns[MeanMaxWorld.WATER][tanker], bodies.radius[tanker]);
        }
        bodies.remove(tanker);
        return Verdict.CHANGED;
    }
}
