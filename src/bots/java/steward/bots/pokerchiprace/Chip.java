package steward.bots.pokerchiprace;

/** A chip on the table. */
final class Chip {

    int id;
    /** The owner, -1 for a neutral chip. */
    int player = -1;
    double radius;
    double x;
    double y;
    double vx;
    double vy;

    /** The distance of two centres, in u. */
    double distance(Chip other) {
        return Math.sqrt((x - other.x) * (x - other.x) + (y - other.y) * (y - other.y));
    }
}
