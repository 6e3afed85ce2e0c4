package steward.game.bodies;

/**
 * A circle that bodies pass over. A body has reached it when its centre is in it at the end of a turn.
 *
 * @param x      its centre, in u
 * @param y      its centre, in u
 * @param radius above 0, in u
 * @param label  for people
 * @param points for the owner of each body in it, every turn
 * @param ends   true if the game ends when a body has reached it
 */
public record Zone(double x, double y, double radius, String label, int points, boolean ends) {

    boolean holds(double bodyX, double bodyY) {
        double dx = bodyX - x;
        double dy = bodyY - y;
        return dx * dx + dy * dy <= radius * radius;
    }
}
