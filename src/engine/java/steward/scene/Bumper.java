package steward.scene;

/**
 * A round body of infinite mass that never moves. Bodies that graze it leave it in a straight line; along the inside of
 * a round wall they slide (see {@link steward.physics.Arena}).
 *
 * @param x           its centre, in u
 * @param y           its centre, in u
 * @param radius      above 0
 * @param restitution 0..1
 */
public record Bumper(double x, double y, double radius, double restitution) { }
