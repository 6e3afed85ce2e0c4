package steward.game.meanmax;

/** A sunken tanker from which reapers harvest water: a place that is no body, with an id from the same counter. */
public final class Wreck {

    private final int id;
    private final double x;
    private final double y;
    private final double radius;
    private int water;

    Wreck(int id, double x, double y, double radius, int water) {
        this.id = id;
        this.x = x;
        this.y = y;
        this.radius = radius;
        this.water = water;
    }

    Wreck copy() {
        return new Wreck(id, x, y, radius, water);
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
