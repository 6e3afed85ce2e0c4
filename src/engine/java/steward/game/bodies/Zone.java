package steward.game.bodies;

/**
 * A circle that bodies can enter without an impact; a body is where its centre is.
 *
 * @param x       its centre, in u
 * @param y       its centre, in u
 * @param radius  above 0, in u
 * @param label   for people
 * @param points  for the owner of each body that reaches it
 * @param ends    true if the game ends when a body has reached it
 * @param removes true if a body that has reached it is taken out
 * @param passing true if a body reaches it when its path enters it, at that time; otherwise in every turn at whose end
 *                it is in it
 */
public record Zone(double x, double y, double radius, String label, int points, boolean ends, boolean removes,
                   boolean passing) {

    /** True if it takes bodies out on their way. */
    boolean isPocket() {
        return passing && removes;
    }

    boolean holds(double bodyX, double bodyY) {
        double dx = bodyX - x;
        double dy = bodyY - y;
        return dx * dx + dy * dy <= radius * radius;
    }

    /*
     * The path from p = (fromX, fromY) by d; e leads from p to the centre. |p + u d - centre| = r where
     *
     *     u^2 d.d - 2 u e.d + e.e - r^2 = 0,     (e.d)^2 - d.d (e.e - r^2) = d.d r^2 - (e x d)^2,
     *
     * so the first u is (e.e - r^2) / (e.d + sqrt(d.d r^2 - (e x d)^2)). Where the path ends before its nearest point,
     * it enters if its end is inside: so one that leaves off at the rim is inside or outside by the numbers of the next
     * turn.
     */

    /** Returns the share of a straight path at which it enters, or NaN if it does not or begins inside. */
    double entry(double fromX, double fromY, double toX, double toY) {
        if (holds(fromX, fromY)) {
            return Double.NaN;
        }
        double dx = toX - fromX;
        double dy = toY - fromY;
        double ex = x - fromX;
        double ey = y - fromY;
        double along = ex * dx + ey * dy;
        double length = dx * dx + dy * dy;
        double across = ex * dy - ey * dx;
        double left = length * radius * radius - across * across;
        boolean dips = along > 0 && along < length && left >= 0;
        if (!dips && !holds(toX, toY)) {
            return Double.NaN;
        }
        double share = (ex * ex + ey * ey - radius * radius) / (along + Math.sqrt(Math.max(0, left)));
        return share >= 0 && share <= 1 ? share : 1;
    }
}
