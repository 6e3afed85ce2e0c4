package steward.game.fantasticbits;

import steward.physics.Bodies;
import steward.physics.Reaction;
import steward.physics.TurnSink;

/**
 * Effects of contacts besides the impulse: wizards take snaffles and carry them, snaffles leave through the goals,
 * bludgers remember whom they have hit. They read and alter the bodies alone. The official expressions use parts of it;
 * if the common law computes a turn, it is the answer to contacts.
 *
 * <p>In that case the goal lines are walls behind the field, at the distance of a snaffle's radius, and the walls
 * between the posts let snaffles pass. Caveat: a capture that is refused is not asked again in the same turn unless the
 * two have separated.
 */
public final class Captures implements Reaction {

    /** Fact: a snaffle (id a) went through a goal; player b scores. */
    public static final int GOAL = 0;
    /** Fact: a wizard (id a) took a snaffle (id b). */
    public static final int CAPTURE = 1;
    /** Fact: a snaffle (id a) met a wall (index b) where the goal is: nothing happened. */
    public static final int OPEN_GOAL = 2;

    /** Within this distance of the centres a wizard takes a snaffle, in u. */
    public static final double REACH = 399;

    /** Index of the first goal line in the scene's walls: left, then right. */
    static final int GOAL_LINES = 4;

    private static final double EPSILON = 1e-5;
    private static final int WIZARD = EntityKind.WIZARD.ordinal();
    private static final int SNAFFLE = EntityKind.SNAFFLE.ordinal();
    private static final int BLUDGER = EntityKind.BLUDGER.ordinal();

    /** The square of the distance of two bodies. */
    static double squared(Bodies bodies, int a, int b) {
        double dx = bodies.x[b] - bodies.x[a];
        double dy = bodies.y[b] - bodies.y[a];
        return dx * dx + dy * dy;
    }

    /** True if a wizard holds a snaffle. */
    static boolean holds(Bodies bodies, int wizard) {
        return bodies.columns[Pitch.HELD][wizard] >= 0;
    }

    /** True if a wizard that holds nothing could take this snaffle if it were near. */
    static boolean isCapturable(Bodies bodies, int wizard, int snaffle) {
        return bodies.kind[snaffle] == SNAFFLE && bodies.columns[Pitch.WAIT][wizard] <= 0;
    }

    /** The capturable snaffle within reach that is nearest to a wizard, of ties the first; -1 if there is none. */
    static int nearest(Bodies bodies, int wizard) {
        int found = -1;
        double least = REACH * REACH;
        for (int k = Pitch.WIZARDS; k < Pitch.firstBludger(bodies); k++) {
            if (isCapturable(bodies, wizard, k)) {
                double distance = squared(bodies, wizard, k);
                if (found < 0 ? distance <= least : distance < least) {
                    found = k;
                    least = distance;
                }
            }
        }
        return found;
    }

    /**
     * A wizard takes a snaffle, unless it holds one by now or another free wizard is as near. @return whether it did
     */
    static boolean capture(Bodies bodies, int wizard, int snaffle, double time, TurnSink sink) {
        if (holds(bodies, wizard)) {
            return false;
        }
        double distance = squared(bodies, snaffle, wizard) + EPSILON;
        for (int other = 0; other < Pitch.WIZARDS; other++) {
            if (other != wizard && !holds(bodies, other) && distance >= squared(bodies, snaffle, other)) {
                return false;
            }
        }
        sink.knot(bodies.id(snaffle), time, bodies.x[snaffle], bodies.y[snaffle]);
        bodies.columns[Pitch.HELD][wizard] = bodies.id(snaffle);
        if (bodies.kind[snaffle] == SNAFFLE) {
            bodies.kind[snaffle] = EntityKind.HELD_SNAFFLE.ordinal();
        }
        carry(bodies, wizard);
        sink.knot(bodies.id(snaffle), time, bodies.x[snaffle], bodies.y[snaffle]);
        sink.fact(time, CAPTURE, bodies.id(wizard), bodies.id(snaffle), bodies.x[snaffle], bodies.y[snaffle], 0, 0);
        return true;
    }

    /** The snaffle that a wizard holds takes over its place and speed. @return whether it holds one */
    static boolean carry(Bodies bodies, int wizard) {
        if (!holds(bodies, wizard)) {
            return false;
        }
        int snaffle = (int) bodies.columns[Pitch.HELD][wizard];
        bodies.x[snaffle] = bodies.x[wizard];
        bodies.y[snaffle] = bodies.y[wizard];
        bodies.vx[snaffle] = bodies.vx[wizard];
        bodies.vy[snaffle] = bodies.vy[wizard];
        return true;
    }

    /** A snaffle leaves play for a player's goal. */
    static void score(Bodies bodies, int snaffle, int player, double time, TurnSink sink) {
        bodies.kind[snaffle] = EntityKind.LOST_SNAFFLE.ordinal();
        sink.fact(time, GOAL, bodies.id(snaffle), player, bodies.x[snaffle], bodies.y[snaffle], 0, 0);
    }

    /** Notes an impact in the memory of a wizard or bludger. @return whether a held snaffle was moved */
    static boolean afterImpact(Bodies bodies, int a, int b, double time, TurnSink sink) {
        if (b >= 0 && bodies.kind[a] == BLUDGER && bodies.kind[b] == WIZARD) {
            bodies.columns[Pitch.LAST_VICTIM][a] = bodies.id(b);
        } else if (b >= 0 && bodies.kind[a] == WIZARD && bodies.kind[b] == BLUDGER) {
            bodies.columns[Pitch.LAST_VICTIM][b] = bodies.id(a);
        }
        boolean moved = bodies.kind[a] == WIZARD && follow(bodies, a, time, sink);
        return b >= 0 && bodies.kind[b] == WIZARD && follow(bodies, b, time, sink) || moved;
    }

    private static boolean follow(Bodies bodies, int wizard, double time, TurnSink sink) {
        if (carry(bodies, wizard)) {
            sink.knot((int) bodies.columns[Pitch.HELD][wizard], time, bodies.x[wizard], bodies.y[wizard]);
            return true;
        }
        return false;
    }

    @Override
    public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
        if (b < 0) {
            return atWall(time, a, ~b, bodies, sink);
        }
        int first = Math.min(bodies.kind[a], bodies.kind[b]);
        int second = Math.max(bodies.kind[a], bodies.kind[b]);
        if (second >= EntityKind.HELD_SNAFFLE.ordinal()) {
            return Verdict.PASS;                      // taken or lost by an earlier contact of the same batch
        }
        if (first == SNAFFLE && second == SNAFFLE) {
            return Pitch.ignores(bodies, Math.max(a, b), Math.min(a, b)) ? Verdict.PASS : Verdict.BOUNCE;
        }
        if (first != WIZARD || second != SNAFFLE) {
            return Verdict.BOUNCE;
        }
        int wizard = bodies.kind[a] == WIZARD ? a : b;
        int snaffle = a + b - wizard;
        if (!isCapturable(bodies, wizard, snaffle)) {
            return Verdict.PASS;
        }
        int nearest = nearest(bodies, wizard);
        boolean isNearest = nearest < 0 || nearest == snaffle;
        return isNearest && capture(bodies, wizard, snaffle, time, sink) ? Verdict.ALTERED : Verdict.PASS;
    }

    private static Verdict atWall(double time, int a, int wall, Bodies bodies, TurnSink sink) {
        if (bodies.kind[a] != SNAFFLE) {
            return bodies.kind[a] == WIZARD ? Verdict.BOUNCE : Verdict.PASS;
        }
        if (wall >= GOAL_LINES) {
            score(bodies, a, wall == GOAL_LINES ? 1 : 0, time, sink);
            return Verdict.ALTERED;
        }
        boolean side = wall % 2 == 0;
        return side && Pitch.isInMouth(bodies.y[a]) ? Verdict.PASS : Verdict.BOUNCE;
    }

    @Override
    public boolean after(double time, int a, int b, Bodies bodies, TurnSink sink) {
        return afterImpact(bodies, a, b, time, sink);
    }
}
