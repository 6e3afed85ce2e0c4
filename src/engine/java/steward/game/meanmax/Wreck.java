package steward.game.meanmax;

/**
 * A sunken tanker from which reapers harvest water, or the water of a league without tankers. It is a place, not a
 * body, with an id from the same counter. When it is gone, a later turn may reuse the object.
 */
public final class Wreck {

    /** Buckets of a hash table of Java with up to 12 elements; at most 9 wrecks come by themselves. */
    static final int BUCKETS = 16;

    private int id;
    private double x;
    private double y;
    private double radius;
    private int water;
    private int player;

    Wreck set(int newId, double newX, double newY, double newRadius, int newWater, int newPlayer) {
        id = newId;
        x = newX;
        y = newY;
        radius = newRadius;
        water = newWater;
        player = newPlayer;
        return this;
    }

    Wreck copy() {
        return new Wreck().set(id, x, y, radius, water, player);
    }

    void takeWater() {
        water--;
    }

    /** The bucket of a hash table of Java in which a place with these coordinates lies. */
    int bucket() {
        int hash = 31 * (31 + Double.hashCode(x)) + Double.hashCode(y);
        return (hash ^ hash >>> 16) & BUCKETS - 1;
    }

    public int id() {
        return id;
    }

    /** Its centre, in u; a whole number where a tanker has sunk. */
    public double x() {
        return x;
    }

    /** Its centre, in u; a whole number where a tanker has sunk. */
    public double y() {
        return y;
    }

    /** Its radius, that of its tanker, in u. */
    public double radius() {
        return radius;
    }

    /** The player for whom another comes when it is gone; -1 where tankers bring the water. */
    public int player() {
        return player;
    }

    /** The water left; above 0 between turns. */
    public int water() {
        return water;
    }
}
