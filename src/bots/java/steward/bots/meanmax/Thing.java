package steward.bots.meanmax;

/** Something in the arena: a looter, a tanker, a wreck or a skill effect. Fields that it does not have are 0. */
final class Thing {

    /** Kind of unit: {@code reaper}, {@code destroyer}, {@code doof}, {@code tanker}; empty for the rest. */
    String kind = "";
    /** The skill of an effect; empty for the rest. */
    String skill = "";
    /** -1 without owner. */
    int player = -1;
    double x;
    double y;
    double vx;
    double vy;
    double mass;
    double radius;
    int water;
    int size;

    /** The distance of two centres, in u. */
    double distance(Thing other) {
        return distance(other.x, other.y);
    }

    /** The distance of the centre from a place, in u. */
    double distance(double toX, double toY) {
        return Math.sqrt((x - toX) * (x - toX) + (y - toY) * (y - toY));
    }
}
