package steward.physics.impulse;

import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;
import steward.physics.Wall;

/*
 * Room R for the centre of a body, speed s. A chord that makes an angle theta with the rim at both ends has the length
 * 2 R sin theta and covers 2 theta of the rim. Chords that last tau turns have sin theta = s tau / 2R. The arc of that
 * length covers s tau / R = 2 sin theta, so the end of a chord is ahead by
 *
 *     2 (theta - sin theta) = x^3 / 3 + 3 x^5 / 20 + ...,   x = sin theta,
 *
 * and by this angle the body is moved back along the rim. What is left is below x^7 / 14, 6e-11 for the steepest chord.
 * Between its ends a chord is up to R theta^2 / 2 inside the rim, and the body up to theta^3 / 3 ahead of its place:
 * 3e-7 where it covers 5 radians in a turn.
 */

/**
 * Sliding along the rim of an {@link Arena}. A body that moves along a concave wall is in contact all the time: bounces
 * would follow each other without end. With restitution below 1, a contact after which the next one would come within
 * 1/{@value #CHORDS} of a turn or so is no bounce: the body keeps its speed, is put exactly on the rim and flies on
 * along the chord to the place where it will be on the rim 1/{@value #CHORDS} turn later. On the chord it meets others
 * as in any flight. Bodies that cover more than 25 radians in a turn make longer flights of a tenth of a radian each,
 * very slow ones flights of 2e-6 radians.
 *
 * <p>An elastic body keeps the angle of its bounces: it slides only if they are more than {@value #MOST_BOUNCES} a
 * turn, too flat to be told from a slide.
 *
 * <p>Caveats: a slide that begins at an angle alpha keeps the whole speed, of which the share alpha^2 / 2 was not along
 * the rim: the body is then up to 4.5e-6 w^3 radians ahead after a turn of w radians, elastic ones 2e-9 w^3. Between
 * two contacts velocity and place are those on the chord, off those on the rim by up to theta and R theta^2 / 2, where
 * 2 theta is the angle of a chord. Such a contact is a knot of the path; under laws without rest it is recorded as an
 * impact, too, with the change of energy 0 and the direction of the change of momentum as its normal, which is off the
 * normal of the rim by up to theta.
 */
final class RimSliding {

    /** Chords in a turn: leaves some of 256 for contacts at which a slide begins. */
    static final int CHORDS = 250;
    /** Bounces of an elastic body in a turn, at most; half of the least default bound on the impacts of a turn. */
    static final int MOST_BOUNCES = 5000;
    /**
     * Chords of an elastic slide, as a share of the others. It is no simple number, so that a flight is taken for such
     * a chord only if it is one, not because a scene has bounces of that angle.
     */
    private static final double ELASTIC_CHORD = 1.0037192865043;
    /** The steepest chord, sin theta: 25 rad a turn. */
    private static final double STEEPEST = 0.05;
    /** The flattest: its depth, 5e-13 of the room, is well above the rounding of coordinates. */
    private static final double FLATTEST = 0x1p-20;
    /** A contact up to this much steeper than the chord of its speed begins a slide. */
    private static final double STEEPER = 1.5;
    /** A flight whose angle is that of the chord to this share was such a chord. */
    private static final double SAME = 1e-6;
    /** Contacts farther off the rim than this share of the room are not exact: fixed steps have such. */
    private static final double OFF_RIM = 0x1p-30;

    /** True if bodies can slide: in an arena, where no minimum impulse drives them off its rim. */
    static boolean isPossible(ImpactLaw law, Wall[] walls) {
        boolean arena = false;
        for (Wall wall : walls) {
            arena |= wall instanceof Arena;
        }
        return arena && !(law.minimumImpulseAtWalls() && law.minimumImpulse() > 0);
    }

    /** True if a body touches an arena so flatly that it slides, by the lower of two restitutions. */
    static boolean grazes(Bodies bodies, int a, Wall wall) {
        return grazes(bodies, a, wall, Math.min(bodies.restitution[a], wall.restitution()));
    }

    private static boolean grazes(Bodies bodies, int a, Wall wall, double restitution) {
        if (!(wall instanceof Arena arena)) {
            return false;
        }
        double vx = bodies.vx[a];
        double vy = bodies.vy[a];
        double speed = Math.sqrt(vx * vx + vy * vy);
        double dx = bodies.x[a] - arena.x();
        double dy = bodies.y[a] - arena.y();
        double distance = Math.sqrt(dx * dx + dy * dy);
        double room = arena.radius() - bodies.radius[a];
        double rise = (dx * vx + dy * vy) / distance;
        if (!(room > 0 && speed > 0 && Math.abs(distance - room) <= OFF_RIM * room)) {
            return false;
        }
        double chord = chord(speed, room, restitution);
        return restitution == 1
            ? Math.abs(rise) * MOST_BOUNCES * 2 * room <= speed * speed || isChord(rise / speed, chord)
            : Math.abs(rise) <= STEEPER * chord * speed;
    }

    /** The angle of a chord, sin theta. */
    private static double chord(double speed, double room, double restitution) {
        double chord = Math.min(STEEPEST, Math.max(FLATTEST, speed / (2 * CHORDS * room)));
        return restitution == 1 ? ELASTIC_CHORD * chord : chord;
    }

    /** True if a flight that ends with this sine of its angle to the rim was a chord of a slide. */
    private static boolean isChord(double rise, double chord) {
        return Math.abs(rise - chord) <= SAME * chord;
    }

    /**
     * Starts the next chord of a body that touches a wall.
     *
     * @param restitution of the contact
     * @param records     whether the contact is recorded as an impact
     * @return false if it bounces instead, or has no room
     */
    static boolean slide(Bodies bodies, int a, int w, Wall wall, double restitution, double time, boolean records,
                         TurnSink sink) {
        if (!grazes(bodies, a, wall, restitution)) {
            return false;
        }
        Arena arena = (Arena) wall;
        double vx = bodies.vx[a];
        double vy = bodies.vy[a];
        double speed = Math.sqrt(vx * vx + vy * vy);
        double dx = bodies.x[a] - arena.x();
        double dy = bodies.y[a] - arena.y();
        double distance = Math.sqrt(dx * dx + dy * dy);
        double room = arena.radius() - bodies.radius[a];
        double nx = dx / distance;
        double ny = dy / distance;
        double rise = (nx * vx + ny * vy) / speed;
        double chord = chord(speed, room, restitution);
        double turn = nx * vy - ny * vx > 0 ? 1 : -1;
        if (isChord(rise, chord)) {
            double ahead = chord * chord * chord * (1.0 / 3 + 3.0 / 20 * chord * chord);
            double x = nx + turn * ahead * ny;
            double y = ny - turn * ahead * nx;
            double length = Math.sqrt(x * x + y * y);
            nx = x / length;
            ny = y / length;
        }
        double along = Math.sqrt(1 - chord * chord) * turn;
        setVelocity(bodies, a, speed, -ny * along - nx * chord, nx * along - ny * chord);
        bodies.x[a] = arena.x() + nx * room;
        bodies.y[a] = arena.y() + ny * room;
        if (records) {
            double changeX = vx - bodies.vx[a];
            double changeY = vy - bodies.vy[a];
            double change = Math.sqrt(changeX * changeX + changeY * changeY);
            sink.impact(time, bodies.id(a), ~w, bodies.x[a], bodies.y[a], arena.x() + nx * arena.radius(),
                arena.y() + ny * arena.radius(), changeX / change, changeY / change, change * bodies.mass[a], 0,
                bodies.mass[a], Double.POSITIVE_INFINITY, vx, vy, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        }
        sink.knot(bodies.id(a), time, bodies.x[a], bodies.y[a]);
        return true;
    }

    /**
     * Sets the velocity along a vector whose length is 1 but for rounding. The same rounding at every chord would
     * change the energy by as much each time, so what it changes is taken back: v^2 - v'^2 = (v - v').(v + v').
     */
    private static void setVelocity(Bodies bodies, int a, double speed, double alongX, double alongY) {
        double x = speed * alongX;
        double y = speed * alongY;
        double lost = (bodies.vx[a] - x) * (bodies.vx[a] + x) + (bodies.vy[a] - y) * (bodies.vy[a] + y);
        double share = lost / (2 * speed * speed);
        bodies.vx[a] = x + x * share;
        bodies.vy[a] = y + y * share;
    }
}
