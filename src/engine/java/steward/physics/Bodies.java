package steward.physics;

import java.util.Arrays;

/**
 * All bodies of a scene: circles with a position, a velocity and a few properties. One array per quantity, indexed
 * 0..{@link #size()}-1, read and written directly by the advance: a turn visits all bodies in order, so the loop runs
 * through contiguous memory, and nothing is allocated.
 *
 * <p>A body keeps its <em>id</em> for life; its <em>index</em> is its place in the arrays. Ids are given in ascending
 * order and removal keeps the order, so that ids ascend with the index and "the lowest pair of ids" is also the lowest
 * pair of indices. Adding and removing are legal between turns and inside a {@link Reaction}. The capacity is fixed:
 * the arrays never move.
 */
public final class Bodies {

    /** Positions of the centres, to the right, in u. */
    public final double[] x;
    /** Positions of the centres, downwards, in u. */
    public final double[] y;
    /** Velocities to the right, in u per turn. */
    public final double[] vx;
    /** Velocities downwards, in u per turn. */
    public final double[] vy;
    /** Radii, in u, above 0; 0 for a point. */
    public final double[] radius;
    /** Masses, above 0; {@code POSITIVE_INFINITY} is a body that no impulse moves. Change with {@link #setMass}. */
    public final double[] mass;
    /** 1 / mass, 0 for an infinite mass. Change with {@link #setMass}. */
    public final double[] inverseMass;
    /** The share of an approach speed that an impact gives back, 0..1. */
    public final double[] restitution;
    /** The share of its speed that a body loses at the end of a turn, 0..1. */
    public final double[] drag;
    /**
     * More quantities of a game, one array each, 0 for a new body: they move, die and are copied with their bodies. The
     * physics does not read them.
     */
    public final double[][] columns;
    /** The kind of a body, 0..{@link Contacts#kinds()}-1: decides what a contact means. */
    public final int[] kind;

    private final int[] id;
    private final double[][] quantities;
    private int size;
    private int nextId;
    private final PassingPairs passing = new PassingPairs();

    /**
     * @param capacity maximum number of bodies at a time, at least 1
     * @throws IllegalArgumentException if the capacity is below 1
     */
    public Bodies(int capacity) {
        this(capacity, 0);
    }

    /**
     * @param capacity maximum number of bodies at a time, at least 1
     * @param columns  how many quantities of the game's own each body has
     * @throws IllegalArgumentException if the capacity is below 1 or the number of columns below 0
     */
    public Bodies(int capacity, int columns) {
        if (columns < 0) {
            throw new IllegalArgumentException(columns + " columns, expected at least 0");
        }
        if (capacity < 1) {
            throw new IllegalArgumentException("capacity " + capacity + ", expected at least 1");
        }
        x = new double[capacity];
        y = new double[capacity];
        vx = new double[capacity];
        vy = new double[capacity];
        radius = new double[capacity];
        mass = new double[capacity];
        inverseMass = new double[capacity];
        restitution = new double[capacity];
        drag = new double[capacity];
        kind = new int[capacity];
        id = new int[capacity];
        this.columns = new double[columns][capacity];
        double[][] common = {x, y, vx, vy, radius, mass, inverseMass, restitution, drag};
        quantities = Arrays.copyOf(common, common.length + columns);
        System.arraycopy(this.columns, 0, quantities, common.length, columns);
    }

    /**
     * Adds a body at rest with restitution 1, no drag and kind 0; the {@code set} methods change these.
     *
     * @param mass above 0; {@code POSITIVE_INFINITY} for a body that no impulse moves
     * @return its index, always {@code size() - 1}
     * @throws IllegalArgumentException if a value is NaN, infinite (except the mass) or out of range, or the mass so
     *                                  small (below 5.6e-309) that its inverse is infinite
     * @throws IllegalStateException    if the capacity is used up
     */
    public int add(double x, double y, double radius, double mass) {
        requireRadius(size, radius);
        return addOfAnyRadius(x, y, radius, mass);
    }

    /**
     * Adds a point: a body of radius 0 at rest, for games without contacts between bodies. Otherwise as {@link #add}.
     */
    public int addPoint(double x, double y, double mass) {
        return addOfAnyRadius(x, y, 0, mass);
    }

    private int addOfAnyRadius(double x, double y, double radius, double mass) {
        if (size == this.x.length) {
            throw new IllegalStateException("capacity of " + size + " bodies is used up");
        }
        int body = size;
        requireFinite(body, "x", x);
        requireFinite(body, "y", y);
        requireMass(body, mass);
        this.x[body] = x;
        this.y[body] = y;
        vx[body] = 0;
        vy[body] = 0;
        this.radius[body] = radius;
        this.mass[body] = mass;
        inverseMass[body] = 1 / mass;
        restitution[body] = 1;
        drag[body] = 0;
        kind[body] = 0;
        for (double[] column : columns) {
            column[body] = 0;
        }
        id[body] = nextId++;
        size++;
        return body;
    }

    /**
     * Sets the centre, in u.
     *
     * @throws IllegalArgumentException unless both are finite
     */
    public void setPosition(int body, double x, double y) {
        requireFinite(body, "x", x);
        requireFinite(body, "y", y);
        this.x[body] = x;
        this.y[body] = y;
    }

    /**
     * Sets the velocity, in u per turn.
     *
     * @throws IllegalArgumentException unless both are finite
     */
    public void setVelocity(int body, double vx, double vy) {
        requireFinite(body, "vx", vx);
        requireFinite(body, "vy", vy);
        this.vx[body] = vx;
        this.vy[body] = vy;
    }

    /**
     * Sets the radius, in u.
     *
     * @throws IllegalArgumentException unless it is finite and above 0
     */
    public void setRadius(int body, double radius) {
        requireRadius(body, radius);
        this.radius[body] = radius;
    }

    /**
     * Sets the mass and its inverse.
     *
     * @throws IllegalArgumentException unless it is above 0; it may be infinite
     */
    public void setMass(int body, double mass) {
        requireMass(body, mass);
        this.mass[body] = mass;
        inverseMass[body] = 1 / mass;
    }

    /**
     * Sets the share of an approach speed that an impact gives back.
     *
     * @throws IllegalArgumentException unless it is 0..1
     */
    public void setRestitution(int body, double restitution) {
        requireShare(body, "restitution", restitution);
        this.restitution[body] = restitution;
    }

    /**
     * Sets the share of its speed that the body loses at the end of a turn.
     *
     * @throws IllegalArgumentException unless it is 0..1
     */
    public void setDrag(int body, double drag) {
        requireShare(body, "drag", drag);
        this.drag[body] = drag;
    }

    /**
     * Sets the kind, which decides what contacts mean.
     *
     * @throws IllegalArgumentException if it is below 0
     */
    public void setKind(int body, int kind) {
        if (kind < 0) {
            throw new IllegalArgumentException(name(body) + ": kind " + kind + ", expected at least 0");
        }
        this.kind[body] = kind;
    }

    /** Removes a body; the index of each later body falls by one; ids stay. */
    public void remove(int body) {
        if (body < 0 || body >= size) {
            throw new IndexOutOfBoundsException("body " + body + " of " + size);
        }
        int behind = size - body - 1;
        for (double[] quantity : quantities) {
            System.arraycopy(quantity, body + 1, quantity, body, behind);
        }
        System.arraycopy(kind, body + 1, kind, body, behind);
        System.arraycopy(id, body + 1, id, body, behind);
        size--;
    }

    public int size() {
        return size;
    }

    /** The maximum number of bodies at a time. */
    public int capacity() {
        return x.length;
    }

    /** The id of the body at an index. */
    public int id(int body) {
        return id[body];
    }

    /** The index of the body with an id, or -1 if it was removed. */
    public int indexOf(int bodyId) {
        int found = Arrays.binarySearch(id, 0, size, bodyId);
        return found < 0 ? -1 : found;
    }

    /** The id that the next body will get. */
    public int nextId() {
        return nextId;
    }

    /**
     * Takes the id that the next body would get, for a thing that is no body but is counted with them.
     *
     * @return the id
     */
    public int takeId() {
        return nextId++;
    }

    /** The pairs that pass through each other because a {@link Reaction} answered {@code PASS}; part of the state. */
    public PassingPairs passing() {
        return passing;
    }

    /** A copy with the same capacity and columns. */
    public Bodies copy() {
        Bodies copy = new Bodies(capacity(), columns.length);
        copy.copyFrom(this);
        return copy;
    }

    /**
     * Copies another set of bodies exactly.
     *
     * @throws IllegalArgumentException if the capacities or the numbers of columns differ
     */
    public void copyFrom(Bodies other) {
        if (capacity() != other.capacity()) {
            throw new IllegalArgumentException("capacity " + other.capacity() + ", expected " + capacity());
        }
        if (columns.length != other.columns.length) {
            throw new IllegalArgumentException(other.columns.length + " columns, expected " + columns.length);
        }
        size = other.size;
        nextId = other.nextId;
        for (int q = 0; q < quantities.length; q++) {
            System.arraycopy(other.quantities[q], 0, quantities[q], 0, size);
        }
        System.arraycopy(other.kind, 0, kind, 0, size);
        System.arraycopy(other.id, 0, id, 0, size);
        passing.copyFrom(other.passing);
    }

    private String name(int body) {
        return body < size ? "body " + id[body] : "body " + nextId;
    }

    private void requireFinite(int body, String what, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(name(body) + ": " + what + " " + value + ", expected a finite number");
        }
    }

    private void requireRadius(int body, double value) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(name(body) + ": radius " + value + ", expected finite and above 0");
        }
    }

    private void requireMass(int body, double value) {
        if (!(value > 0) || 1 / value == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(name(body) + ": mass " + value + ", expected above 0 (or infinite)");
        }
    }

    private void requireShare(int body, String what, double value) {
        if (!(value >= 0 && value <= 1)) {
            throw new IllegalArgumentException(name(body) + ": " + what + " " + value + ", expected 0..1");
        }
    }
}
