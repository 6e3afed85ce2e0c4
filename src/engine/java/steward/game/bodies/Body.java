package steward.game.bodies;

/**
 * A disc before the first turn.
 *
 * @param x           its centre, in u
 * @param y           its centre, in u
 * @param vx          in u per turn
 * @param vy          in u per turn
 * @param radius      above 0, in u
 * @param mass        above 0; {@code POSITIVE_INFINITY} for a disc that no impulse moves
 * @param restitution 0..1
 * @param drag        the share of its speed that it loses at the end of a turn, 0..1
 * @param owner       the player who commands it, or {@link #NOBODY}
 * @param label       for people; may be empty
 * @param colour      {@code #rrggbb}, or empty for that of its owner
 */
public record Body(double x, double y, double vx, double vy, double radius, double mass, double restitution,
                   double drag, int owner, String label, String colour) {

    /** Owner of a disc that no player commands. */
    public static final int NOBODY = -1;

    /** Returns this disc elsewhere. */
    Body at(double otherX, double otherY, double otherVx, double otherVy, double otherRadius) {
        return new Body(otherX, otherY, otherVx, otherVy, otherRadius, mass, restitution, drag, owner, label, colour);
    }
}
