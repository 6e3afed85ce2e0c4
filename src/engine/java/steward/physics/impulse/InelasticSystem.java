package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;

/*
 * Contacts k with normals n_k from a_k to b_k, approach speeds u_k = n_k.(va - vb) and speeds s_k that these may keep;
 * impulses j_k >= 0 along them change u by -A j, A_kl the sum over shared bodies of the signs times w n_k.n_l. Wanted
 * are the least impulses after which nothing approaches faster, u' = u - A j <= s, with j_k > 0 only where u'_k = s_k:
 * the velocities nearest to the old ones, measured by the kinetic energy, of the convex set {u <= s} (B. Maury, "A
 * time-stepping scheme for inelastic collisions", Numerische Mathematik 102, 2006; s = 0 is J. J. Moreau's inelastic
 * impact). Rest belongs to the set, so the projection is not longer than what is projected: the energy never rises.
 * The velocities are unique even if the impulses are not.
 */

/**
 * Solver for the least impulses after which no contact of a heap approaches faster than it may. A contact that is held
 * does not open either. Up to {@value #MOST_DENSE} contacts are solved by a {@link DenseActiveSet}, more by a
 * {@link SparseActiveSet}: the same velocities but for rounding.
 */
final class InelasticSystem {

    /** Up to so many contacts a dense factor is as fast as a sparse one. */
    static final int MOST_DENSE = 24;

    /** Velocities of all bodies after the impulses. */
    double[] vx = new double[0];
    double[] vy = new double[0];
    int size;
    int[] a = new int[0];
    /** Another body, or {@code ~wall}. */
    int[] b = new int[0];
    double[] normalX = new double[0];
    double[] normalY = new double[0];
    double[] impulse = new double[0];
    /** The approach speed that a contact may keep. */
    double[] allowed = new double[0];
    /** True for a contact that may not open either: its impulse may be negative. */
    boolean[] held = new boolean[0];
    /** Speed that is to be taken of an approach, before the impulses. */
    private double[] approach = new double[0];
    /** Velocities before the impulses. */
    private double[] fromX = new double[0];
    private double[] fromY = new double[0];
    /** Of a body, its last contact as the first of the two, or -1; and of a contact, the one before it. */
    private int[] last = new int[0];
    private int[] previous = new int[0];
    private double parting;
    private final DenseActiveSet dense = new DenseActiveSet(this);
    private final SparseFactor factor = new SparseFactor(this);
    private final SparseActiveSet sparse = new SparseActiveSet(this, factor);
    /** Places of contacts while they are sorted. */
    private int[] sorted = new int[0];

    /**
     * Begins an empty system of bodies; contacts that may keep no approach have to part at a speed of at least 0.
     *
     * @param x with y, velocities before the impulses; read until the next begin
     */
    void begin(Bodies bodies, double[] x, double[] y, double at) {
        size = 0;
        beginFrom(bodies, x, y, at);
        Arrays.fill(last, 0, bodies.size(), -1);
    }

    /** Begins again with the same contacts and other velocities; {@link #find} no longer finds them. */
    void beginFrom(Bodies bodies, double[] x, double[] y, double at) {
        if (vx.length < bodies.size()) {
            vx = new double[bodies.capacity()];
            vy = new double[bodies.capacity()];
            last = new int[bodies.capacity()];
        }
        fromX = x;
        fromY = y;
        System.arraycopy(x, 0, vx, 0, bodies.size());
        System.arraycopy(y, 0, vy, 0, bodies.size());
        sparse.begin();
        restart(at);
    }

    /** Forgets the contacts of all systems before: bodies have moved. */
    void forget(Bodies bodies) {
        size = 0;
        factor.forget(bodies);
    }

    /** Takes note that a contact may be added, to this system or to one after it before bodies move. */
    void expect(int body, int other) {
        factor.expect(body, other);
    }

    /** Adds a contact of two that have none, which may keep an approach speed; at 0 it is closed, and has to part. */
    void add(int body, int other, double nx, double ny, double may) {
        if (size == a.length) {
            grow(2 * size + 8);
        }
        a[size] = body;
        b[size] = other;
        normalX[size] = nx;
        normalY[size] = ny;
        allowed[size] = may;
        held[size] = false;
        previous[size] = last[body];
        last[body] = size;
        enter(size++);
    }

    /** Gives a contact another normal and another speed that it may keep; solved from the next restart on. */
    void turn(int k, double nx, double ny, double may) {
        normalX[k] = nx;
        normalY[k] = ny;
        allowed[k] = may;
    }

    private void enter(int k) {
        approach[k] = left(k, fromX, fromY);
        impulse[k] = 0;
        if (k < MOST_DENSE) {
            dense.enter(k);
        }
    }

    private void grow(int capacity) {
        a = Arrays.copyOf(a, capacity);
        b = Arrays.copyOf(b, capacity);
        normalX = Arrays.copyOf(normalX, capacity);
        normalY = Arrays.copyOf(normalY, capacity);
        impulse = Arrays.copyOf(impulse, capacity);
        allowed = Arrays.copyOf(allowed, capacity);
        approach = Arrays.copyOf(approach, capacity);
        held = Arrays.copyOf(held, capacity);
        previous = Arrays.copyOf(previous, capacity);
        sorted = new int[capacity];
    }

    /** Exchanges two contacts of a solved system, which has to begin again; {@link #find} no longer finds them. */
    void swap(int k, int l) {
        int body = a[k];
        int other = b[k];
        double nx = normalX[k];
        double ny = normalY[k];
        double j = impulse[k];
        double may = allowed[k];
        allowed[k] = allowed[l];
        allowed[l] = may;
        boolean isHeld = held[k];
        held[k] = held[l];
        held[l] = isHeld;
        a[k] = a[l];
        b[k] = b[l];
        normalX[k] = normalX[l];
        normalY[k] = normalY[l];
        impulse[k] = impulse[l];
        a[l] = body;
        b[l] = other;
        normalX[l] = nx;
        normalY[l] = ny;
        impulse[l] = j;
    }

    /** Sorts the contacts of a solved system by the lower id, then the other; walls last. Ids ascend with indices. */
    void sort(Bodies bodies) {
        int count = 0;
        for (int i = 0; i < bodies.size(); i++) {
            int first = count;
            for (int k = last[i]; k >= 0; k = previous[k]) {
                int place = count++;
                for (; place > first && isLower(k, sorted[place - 1]); place--) {
                    sorted[place] = sorted[place - 1];
                }
                sorted[place] = k;
            }
        }
        for (int place = 0; place < size; place++) {
            int k = sorted[place];
            while (k < place) {
                k = sorted[k];                                // where an exchange before has put it
            }
            swap(place, k);
        }
    }

    private boolean isLower(int k, int l) {
        boolean wallK = b[k] < 0;
        boolean wallL = b[l] < 0;
        return wallK != wallL ? wallL : wallK ? b[k] > b[l] : b[k] < b[l];
    }

    /** Returns the contact of these two, or -1. */
    int find(int body, int other) {
        int k = last[body];
        while (k >= 0 && b[k] != other) {
            k = previous[k];
        }
        return k;
    }

    /** Returns the approach speed of a contact after the impulses. */
    double approach(int k) {
        return approach(k, vx, vy);
    }

    double approach(int k, double[] ofX, double[] ofY) {
        double x = ofX[a[k]];
        double y = ofY[a[k]];
        if (b[k] >= 0) {
            x -= ofX[b[k]];
            y -= ofY[b[k]];
        }
        return normalX[k] * x + normalY[k] * y;
    }

    /** Returns the speed that is to be taken of the approach of a contact, before the impulses. */
    double before(int k) {
        return approach[k];
    }

    /** Returns the speed that is left to be taken after the impulses; below 0 if a contact opens faster than needed. */
    double left(int k) {
        return left(k, vx, vy);
    }

    private double left(int k, double[] ofX, double[] ofY) {
        return approach(k, ofX, ofY) + (allowed[k] != 0 ? -allowed[k] : parting);
    }

    /** True if a contact has taken an impulse, or may not open. */
    boolean carries(int k) {
        return impulse[k] > 0 || held[k];
    }

    /** Adds a contact without a gap that does not open, or lets one not open; solved from the next restart on. */
    int hold(int body, int other, double nx, double ny) {
        int k = find(body, other);
        if (k < 0) {
            k = size;
            add(body, other, nx, ny, 0);
        }
        allowed[k] = 0;
        held[k] = true;
        return k;
    }

    /** Solves a system anew of which normals were turned: from the set that it has, if that still is one. */
    void resume(Bodies bodies) {
        for (int k = 0; k < size; k++) {
            approach[k] = left(k, fromX, fromY);
        }
        if (size <= MOST_DENSE && !dense.resume(bodies)) {
            restart(parting);
        }
    }

    /** Forgets all impulses; contacts have to part at another speed. */
    void restart(double at) {
        parting = at;
        dense.clear();
        for (int k = 0; k < size; k++) {
            enter(k);
        }
        sparse.restart();
    }

    /**
     * Computes the impulses.
     *
     * @param tolerance an approach up to this speed remains
     * @return false if a contact cannot part, or a bound on steps was reached
     */
    boolean solve(Bodies bodies, double tolerance) {
        return size <= MOST_DENSE ? dense.solve(bodies, tolerance) : sparse.solve(bodies, tolerance);
    }

    /** Returns the largest change of a velocity by the impulse of one contact. */
    double largestChange(Bodies bodies) {
        double change = 0;
        for (int k = 0; k < size; k++) {
            double inverse = bodies.inverseMass[a[k]];
            inverse = Math.max(inverse, b[k] < 0 ? 0 : bodies.inverseMass[b[k]]);
            change = Math.max(change, Math.abs(impulse[k]) * inverse);
        }
        return change;
    }

    /** Gives the bodies of all contacts the velocities before the impulses. */
    void reset() {
        for (int k = 0; k < size; k++) {
            reset(a[k]);
            if (b[k] >= 0) {
                reset(b[k]);
            }
        }
    }

    private void reset(int i) {
        vx[i] = fromX[i];
        vy[i] = fromY[i];
    }

    /** Computes the velocities after the impulses. */
    void move(Bodies bodies) {
        reset();
        for (int k = 0; k < size; k++) {
            if (impulse[k] != 0) {
                apply(bodies, k);
            }
        }
    }

    /** Applies the impulse of a contact to the velocities. */
    void apply(Bodies bodies, int k) {
        change(bodies, a[k], -impulse[k], k);
        if (b[k] >= 0) {
            change(bodies, b[k], impulse[k], k);
        }
    }

    private void change(Bodies bodies, int i, double by, int k) {
        vx[i] += by * bodies.inverseMass[i] * normalX[k];
        vy[i] += by * bodies.inverseMass[i] * normalY[k];
    }

    /** A_kl. */
    double coupling(Bodies bodies, int k, int l) {
        double weight = 0;
        if (a[k] == a[l]) {
            weight += bodies.inverseMass[a[k]];
        } else if (a[k] == b[l]) {
            weight -= bodies.inverseMass[a[k]];
        }
        if (b[k] >= 0) {
            if (b[k] == b[l]) {
                weight += bodies.inverseMass[b[k]];
            } else if (b[k] == a[l]) {
                weight -= bodies.inverseMass[b[k]];
            }
        }
        return weight * (normalX[k] * normalX[l] + normalY[k] * normalY[l]);
    }
}
