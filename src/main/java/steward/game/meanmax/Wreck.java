package steward.game.meanmax;

/**
 * A sunken tanker from which reapers harvest water: a place that is no body, with an id from the same counter. When it
 * is gone, a later turn may use the object for another.
 */
public final class Wreck {

    private int id;
    private double x;
    private double y;
    private double radius;
    private int water;

    Wreck set(int newId, double newX, double newY, double newRadius, int newWater) {
        id = newId;
        x = newX;
        y = newY;
        radius = newRadius;
        water = newWater;
        return this;
    }

    Wreck copy() {
        return new Wreck().set(id, x, y, radius, water);
    }

    void takeWater() {
        water--;
    }

    /** Its id. */
    public int id() {
        return id;
    }

    /** Its centre, a whole number of u. */
    public double x() {
        return x;
    }

    /** Its centre, a whole number of u. */
    public double y() {
        return y;
    }

    /** Its radius, that of its tanker, in u. */
    public double radius() {
        return radius;
    }

    /** The water left; above 0 between turns. */
    public int water() {
        return water;
    }
}
