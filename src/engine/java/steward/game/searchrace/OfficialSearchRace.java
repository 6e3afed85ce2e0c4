package steward.game.searchrace;

import steward.numerics.StrictAngles;

/**
 * Expressions of the published official referee of the search race, operation by operation, so that positions, headings
 * and times have its bits. Degrees and radians are converted by one multiplication, as the JDK has done since version
 * 9.
 */
public final class OfficialSearchRace {

    /** No checkpoint is reached on this course. */
    static final double NEVER = Double.POSITIVE_INFINITY;

    private static final double FULL_TURN = Math.PI * 2;
    private static final double MAXIMUM_TURN = Math.PI / 10;
    /** Degrees of a radian. */
    public static final double DEGREES = 57.29577951308232;
    private static final double RADIANS = 0.017453292519943295;

    private OfficialSearchRace() { }

    /**
     * The heading after a command to turn toward a place: by at most 18 degrees.
     *
     * @param heading in radians
     * @param dx      the way to the place, not both 0
     */
    static double turned(double heading, double dx, double dy) {
        double wanted = StrictAngles.atan2(dy, dx);
        double off = (wanted - heading) % FULL_TURN;
        off = 2 * off % FULL_TURN - off;
        return Math.abs(off) >= MAXIMUM_TURN ? heading + MAXIMUM_TURN * Math.signum(off) : wanted;
    }

    /** The heading after a command to turn by whole degrees. */
    static double turnedBy(double heading, int degrees) {
        return (heading * DEGREES + degrees) * RADIANS;
    }

    /** A heading at the end of a turn: whole degrees, from 0 to 360; both occur. In radians. */
    static double wholeDegrees(double heading) {
        double whole = Math.floor(heading * DEGREES + 0.5) * RADIANS;
        while (whole > FULL_TURN) {
            whole -= FULL_TURN;
        }
        while (whole < 0) {
            whole += FULL_TURN;
        }
        return whole;
    }

    /** A heading in radians from whole degrees. */
    public static double radians(double degrees) {
        return degrees * RADIANS;
    }

    /** A heading in radians as players see it: whole degrees, 0..360. */
    public static int degrees(double heading) {
        return (int) Math.floor(heading * DEGREES + 0.5);
    }

    /*
     * With d the way from the checkpoint to the car, |d + v t| = r is A t^2 + B t + C = 0 with A = v.v, B = 2 d.v and
     * C = d.d - r^2; the car comes in at the lower root.
     */

    /**
     * Returns how long a car flies until it is in a checkpoint, in turns: 0 if it is in it already, {@link #NEVER} if
     * it never comes there.
     *
     * @param dx the way from the checkpoint to the car, in u
     */
    static double timeTo(double dx, double dy, double vx, double vy, double radius) {
        if (Math.sqrt(dx * dx + dy * dy) <= radius) {
            return 0;
        }
        double a = vx * vx + vy * vy;
        if (vx == 0 && vy == 0 || a <= 0) {
            return NEVER;
        }
        double b = 2.0 * (dx * vx + dy * vy);
        double c = dx * dx + dy * dy - radius * radius;
        double delta = b * b - 4.0 * a * c;
        if (delta < 0) {
            return NEVER;
        }
        double time = (-b - Math.sqrt(delta)) / (2.0 * a);
        return time <= 0 ? NEVER : time;
    }

    /** A time in turns with two decimals, as results are shown. */
    static double shown(double time) {
        return Math.floor(time * 100 + 0.5) / 100;
    }
}
