package steward.game.pokerchiprace;

import steward.physics.Bodies;
import steward.physics.Reaction;
import steward.physics.TurnSink;

/**
 * Reaction of two chips that touch, under the common law. Chips of the same radius bounce; otherwise the bigger eats
 * the smaller, and then every chip that it overlaps. A chip passes the one that it was just ejected from. It alters the
 * bodies alone.
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

    /** Chips that overlap by less, in u, do not meet, as the published referee has it. */
    private static final double OVERLAP = 1e-5;

    @Override
    public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
        if (b < 0) {
            return Verdict.BOUNCE;
        }
        double[] parents = bodies.columns[ChipTable.PARENT];
        if (parents[a] == bodies.id(b) || parents[b] == bodies.id(a)) {
            return Verdict.PASS;
        }
        if (bodies.radius[a] == bodies.radius[b]) {
            return Verdict.BOUNCE;
        }
        int eater = bodies.radius[a] > bodies.radius[b] ? a : b;
        eater = eat(time, eater, eater == a ? b : a, bodies, sink);
        for (int other = overlapped(eater, bodies); other >= 0; other = overlapped(eater, bodies)) {
            boolean eats = bodies.radius[eater] > bodies.radius[other];
            eater = eat(time, eats ? eater : other, eats ? other : eater, bodies, sink);
        }
        return Verdict.CHANGED;
    }

    /** A chip that bounced, also off a wall, forgets what it was ejected from: it may come back to that. */
    @Override
    public boolean after(double time, int a, int b, Bodies bodies, TurnSink sink) {
        bodies.columns[ChipTable.PARENT][a] = -1;
        if (b >= 0) {
            bodies.columns[ChipTable.PARENT][b] = -1;
        }
        return false;
    }

    /** A chip of another radius that one which has just grown overlaps, or -1: the two meet without an approach. */
    private static int overlapped(int grown, Bodies bodies) {
        for (int other = 0; other < bodies.size(); other++) {
            double dx = bodies.x[other] - bodies.x[grown];
            double dy = bodies.y[other] - bodies.y[grown];
            double reach = bodies.radius[other] + bodies.radius[grown] - OVERLAP;
            if (other != grown && dx * dx + dy * dy < reach * reach && bodies.radius[other] != bodies.radius[grown]
                && bodies.columns[ChipTable.PARENT][other] != bodies.id(grown)) {
                return other;
            }
        }
        return -1;
    }

    /** @return the index of the eater without the eaten */
    private static int eat(double time, int eater, int eaten, Bodies bodies, TurnSink sink) {
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
        bodies.columns[ChipTable.PARENT][eater] = -1;
        sink.knot(id, time, bodies.x[eater], bodies.y[eater]);
        bodies.remove(eaten);
        return eater > eaten ? eater - 1 : eater;
    }
}
