package steward.bots.fantasticbits;

/** A wizard, a snaffle or a bludger. Fields that it does not have are as below. */
final class Entity {

    int id;
    /** Kind of entity: {@code wizard}, {@code snaffle} or {@code bludger}. */
    String kind = "";
    /** -1 without owner. */
    int player = -1;
    double x;
    double y;
    double vx;
    double vy;
    /** The id of the snaffle that a wizard holds, or -1. */
    int snaffle = -1;
    /** True if a snaffle is held. */
    boolean held;
    /** Id of the entity on which a wizard's spell is at work, or begins with the next turn; -1 for none. */
    int spellTarget = -1;

    /** The distance of two centres, in u. */
    double distance(Entity other) {
        return distance(other.x, other.y);
    }

    /** The distance of the centre from a place, in u. */
    double distance(double toX, double toY) {
        return Math.sqrt((x - toX) * (x - toX) + (y - toY) * (y - toY));
    }
}
