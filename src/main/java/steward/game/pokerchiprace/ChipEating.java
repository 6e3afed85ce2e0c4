package steward.game.pokerchiprace;

import steward.physics.Bodies;
import steward.physics.Reaction;
import steward.physics.TurnSink;

/**
 * What the touch of two chips does under the common law: chips of the same radius bounce, otherwise the bigger eats the
 * smaller; a chip passes the one that it was just ejected from. Reads and alters the bodies alone.
 */
public final class ChipEating implements Reaction {

    /** Fact: a chip (id a, of player p) was eaten by another (id b) at (x, y). */
    public static final int EATEN = 0;
    /** Fact: it was eaten already, in the same batch, and is eaten once more. */
    public static final int EATEN_AGAIN = 1;
    /** Fact: two chips (ids a, b) that were eaten already, in the same batch, bounce. */
    public static final int BOUNCE_OF_EATEN = 2;
    /** Fact: a chip (id a) that was eaten already meets a wall (b, as {@code ~wall}). */
    public static final int WALL_OF_EATEN = 3;

    @Override
    public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
        double[] parents = bodies.columns[ChipTable.PARENT];
        if (parents[a] == bodies.id(b) || parents[b] == bodies.id(a)) {
            return Verdict.PASS;
        }
        if (bodies.radius[a] == bodies.radius[b]) {
            return Verdict.BOUNCE;
        }
        int eater = bodies.radius[a] > bodies.radius[b] ? a : b;
        int eaten = eater == a ? b : a;
        double mass = bodies.mass[eater];
        double other = bodies.mass[eaten];
        double share = 1 / (other + mass);
        int id = bodies.id(eater);
        int eatenId = bodies.id(eaten);
        sink.knot(id, time, bodies.x[eater], bodies.y[eater]);
        sink.knot(eatenId, time, bodies.x[eaten], bodies.y[eaten]);
        sink.fact(time, EATEN, eatenId, id, bodies.x[eaten], bodies.y[eaten],
            bodies.columns[ChipTable.OWNER][eaten], 0);
        bodies.x[eater] = (bodies.x[eater] * mass + bodies.x[eaten] * other) * share;
        bodies.y[eater] = (bodies.y[eater] * mass + bodies.y[eaten] * other) * share;
        bodies.vx[eater] = (bodies.vx[eater] * mass + bodies.vx[eaten] * other) * share;
        bodies.vy[eater] = (bodies.vy[eater] * mass + bodies.vy[eaten] * other) * share;
        ChipTable.setArea(bodies, eater, mass + other);
        parents[eater] = -1;
        sink.knot(id, time, bodies.x[eater], bodies.y[eater]);
        bodies.remove(eaten);
        return Verdict.CHANGED;
    }
}
