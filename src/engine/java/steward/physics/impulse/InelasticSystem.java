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
 *
 * Solved by active sets, as non-negative least squares (C. L. Lawson, R. J. Hanson, "Solving Least Squares Problems",
 * 1974, chapter 23): the contact that approaches most enters the set; the set is solved by Cholesky; contacts whose
 * impulse would be negative leave it. A contact whose normal depends on those of the set (its pivot vanishes) stays
 * out: what is left of its approach is rounding, or it is squeezed. Contacts may be added to a solved system, which
 * goes on from its set.
 */

/**
 * Solver for the least impulses after which no contact of a heap approaches faster than it may. The order of the
 * contacts decides ties. A contact that is held does not open either. Bounds: {@value #MOST} contacts, {@value #ROUNDS}
 * entries per contact.
 *
 * <p>Over 400 lines, because every step of the solution works on the same arrays.
 */
final class InelasticSystem {

    /** The most contacts in a system. */
    static final int MOST = 512;
    /** Bound on the entries of a contact into the set, on average. */
    private static final int ROUNDS = 4;
    /** A pivot below this share of the diagonal has vanished. */
    private static final double VANISHED = 0x1p-36;

    /** A normal depends on another only if its share of it is above this, not by rounding. */
    private static final double DEPENDENT = 0x1p-30;

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
    private double[] approach = new double[0];
    private double[] trial = new double[0];
    private boolean[] blocked = new boolean[0];
    /** True for a contact that may not open either: its impulse may be negative. */
    boolean[] held = new boolean[0];
    /** Velocities before the impulses. */
    private double[] fromX = new double[0];
    private double[] fromY = new double[0];
    private int[] set = new int[0];
    /** Columns of the Cholesky factor of the set, each {@link #stride} long: row i of column k at k * stride + i. */
    private double[] factor = new double[0];
    private int stride;
    /** A row of the factor while it is computed. */
    private double[] row = new double[0];
    private int active;
    private double parting;
    private int entries;

    /**
     * Begins an empty system of bodies; contacts that may keep no approach have to part at a speed of at least 0.
     *
     * @param x with y, velocities before the impulses; read until the next begin
     */
    void begin(Bodies bodies, double[] x, double[] y, double at) {
        size = 0;
        beginFrom(bodies, x, y, at);
    }

    /** Begins again with the same contacts and other velocities. */
    void beginFrom(Bodies bodies, double[] x, double[] y, double at) {
        if (vx.length < bodies.size()) {
            vx = new double[bodies.capacity()];
            vy = new double[bodies.capacity()];
        }
        fromX = x;
        fromY = y;
        System.arraycopy(x, 0, vx, 0, bodies.size());
        System.arraycopy(y, 0, vy, 0, bodies.size());
        restart(bodies, at);
    }

    /** Adds a contact that may keep an approach speed; at 0 it is closed, and has to part. */
    void add(Bodies bodies, int body, int other, double nx, double ny, double may) {
        if (size == a.length) {
            grow(2 * size + 8);
        }
        a[size] = body;
        b[size] = other;
        normalX[size] = nx;
        normalY[size] = ny;
        allowed[size] = may;
        held[size] = false;
        enter(bodies, size++);
    }

    /** Gives a contact another normal and another speed that it may keep; solved from the next restart on. */
    void turn(int k, double nx, double ny, double may) {
        normalX[k] = nx;
        normalY[k] = ny;
        allowed[k] = may;
    }

    private void enter(Bodies bodies, int k) {
        approach[k] = approach(k, fromX, fromY) + (allowed[k] != 0 ? -allowed[k] : parting);
        impulse[k] = 0;
        blocked[k] = false;
        entries += ROUNDS;
    }

    private void grow(int capacity) {
        a = Arrays.copyOf(a, capacity);
        b = Arrays.copyOf(b, capacity);
        normalX = Arrays.copyOf(normalX, capacity);
        normalY = Arrays.copyOf(normalY, capacity);
        impulse = Arrays.copyOf(impulse, capacity);
        allowed = Arrays.copyOf(allowed, capacity);
        approach = Arrays.copyOf(approach, capacity);
        trial = Arrays.copyOf(trial, capacity);
        blocked = Arrays.copyOf(blocked, capacity);
        held = Arrays.copyOf(held, capacity);
        set = Arrays.copyOf(set, capacity);
    }

    /** Exchanges two contacts of a solved system. */
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

    /** Returns the contact of these two, or -1. */
    int find(int body, int other) {
        for (int k = 0; k < size; k++) {
            if (a[k] == body && b[k] == other) {
                return k;
            }
        }
        return -1;
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

    /** True if a contact has taken an impulse, or may not open. */
    boolean carries(int k) {
        return impulse[k] > 0 || held[k];
    }

    /** Adds a contact without a gap that does not open, or lets one not open; solved from the next restart on. */
    int hold(Bodies bodies, int body, int other, double nx, double ny) {
        int k = find(body, other);
        if (k < 0) {
            k = size;
            add(bodies, body, other, nx, ny, 0);
        }
        allowed[k] = 0;
        held[k] = true;
        return k;
    }

    /** Solves a system anew of which normals were turned: from the set that it has, if that still is one. */
    void resume(Bodies bodies) {
        for (int k = 0; k < size; k++) {
            approach[k] = approach(k, fromX, fromY) + (allowed[k] != 0 ? -allowed[k] : parting);
            blocked[k] = false;
        }
        entries += ROUNDS;
        if (active > 0 && factorize(bodies, 0)) {
            descend(bodies);
        } else {
            restart(bodies, parting);
        }
    }

    /** Forgets all impulses; contacts have to part at another speed. */
    void restart(Bodies bodies, double at) {
        parting = at;
        active = 0;
        entries = 0;
        for (int k = 0; k < size; k++) {
            enter(bodies, k);
        }
    }

    /**
     * Computes the impulses.
     *
     * @param tolerance an approach up to this speed remains
     * @return false if a contact cannot part, or the bound on entries was reached
     */
    boolean solve(Bodies bodies, double tolerance) {
        boolean parts = true;
        for (; entries > 0; entries--) {
            int next = mostApproaching(bodies, tolerance);
            if (next < 0) {
                return parts;
            }
            set[active++] = next;
            int from = active - 1;
            while (!factorize(bodies, from)) {
                from = exchange();
                if (from < 0) {
                    active--;
                    impulse[next] = 0;
                    blocked[next] = true;
                    parts = false;
                    break;
                }
            }
            if (!blocked[next]) {
                descend(bodies);
            }
        }
        return false;
    }

    private int mostApproaching(Bodies bodies, double tolerance) {
        move(bodies);
        int most = -1;
        double speed = tolerance;
        for (int k = 0; k < size; k++) {
            if (impulse[k] == 0 && !blocked[k]) {
                double left = approach(k) + (allowed[k] != 0 ? -allowed[k] : parting);
                left = held[k] ? Math.abs(left) : left;
                if (left > speed) {
                    speed = left;
                    most = k;
                }
            }
        }
        return most;
    }

    /** Computes the velocities after the impulses. */
    private void move(Bodies bodies) {
        for (int k = 0; k < size; k++) {
            reset(a[k]);
            if (b[k] >= 0) {
                reset(b[k]);
            }
        }
        for (int l = 0; l < active; l++) {
            int k = set[l];
            change(bodies, a[k], -impulse[k], k);
            if (b[k] >= 0) {
                change(bodies, b[k], impulse[k], k);
            }
        }
    }

    private void reset(int i) {
        vx[i] = fromX[i];
        vy[i] = fromY[i];
    }

    private void change(Bodies bodies, int i, double by, int k) {
        vx[i] += by * bodies.inverseMass[i] * normalX[k];
        vy[i] += by * bodies.inverseMass[i] * normalY[k];
    }

    /**
     * Lets the last contact of the set, whose normal depends on those of the others, take over their impulses until one
     * of them has none, and leaves the set: no velocity changes.
     *
     * @return which one has left, or -1 if none can: then nothing was altered
     */
    private int exchange() {
        int last = active - 1;
        for (int i = last - 1; i >= 0; i--) {
            int column = i * stride;
            double sum = factor[column + last];
            for (int k = i + 1; k < last; k++) {
                sum -= factor[column + k] * trial[k];
            }
            trial[i] = sum / factor[column + i];
        }
        int leaves = -1;
        double least = 0;
        for (int l = 0; l < last; l++) {
            double until = impulse[set[l]] / trial[l];
            if (trial[l] > DEPENDENT && !held[set[l]] && (leaves < 0 || until < least)) {
                least = until;
                leaves = l;
            }
        }
        if (leaves < 0) {
            return leaves;
        }
        for (int l = 0; l < last; l++) {
            double j = impulse[set[l]] - least * trial[l];
            impulse[set[l]] = held[set[l]] ? j : Math.max(0, j);
        }
        impulse[set[last]] += least;
        leave(leaves);
        return leaves;
    }

    private void leave(int l) {
        impulse[set[l]] = 0;
        active--;
        System.arraycopy(set, l + 1, set, l, active - l);
    }

    /** Moves to the solution of the set, from edge to edge while an impulse would become negative. */
    private void descend(Bodies bodies) {
        for (;;) {
            substitute();
            double share = 1;
            int leaves = -1;
            for (int l = 0; l < active; l++) {
                int k = set[l];
                if (!(trial[l] > 0) && !held[k]) {
                    double until = impulse[k] / (impulse[k] - trial[l]);
                    if (leaves < 0 || until < share) {
                        share = until;
                        leaves = l;
                    }
                }
            }
            for (int l = 0; l < active; l++) {
                int k = set[l];
                impulse[k] = leaves < 0 ? trial[l] : impulse[k] + share * (trial[l] - impulse[k]);
            }
            if (leaves < 0) {
                return;
            }
            leave(leaves);
            if (active == 0 || !factorize(bodies, leaves)) {
                return;
            }
        }
    }

    /**
     * Computes the Cholesky factor of the set from a row on. A row takes each column of those before off the rest of
     * itself at once, which compilers do for several numbers at a time; most columns have nothing to take.
     *
     * @return false if a pivot vanishes
     */
    private boolean factorize(Bodies bodies, int from) {
        if (stride < active) {
            widen(2 * active);
        }
        for (int i = from; i < active; i++) {
            for (int j = 0; j <= i; j++) {
                row[j] = coupling(bodies, set[i], set[j]);
            }
            double whole = row[i];
            for (int k = 0; k < i; k++) {
                int column = k * stride;
                double share = row[k] / factor[column + k];
                factor[column + i] = share;
                if (share != 0) {
                    takeOff(column, share, k + 1, i + 1);
                }
            }
            if (!(row[i] > VANISHED * whole)) {
                return false;
            }
            factor[i * stride + i] = Math.sqrt(row[i]);
        }
        return true;
    }

    private void takeOff(int column, double share, int from, int to) {
        for (int j = from; j < to; j++) {
            row[j] -= share * factor[column + j];
        }
    }

    private void widen(int wider) {
        double[] old = factor;
        factor = new double[wider * wider];
        for (int k = 0; k < stride; k++) {
            System.arraycopy(old, k * stride, factor, k * wider, stride);
        }
        row = new double[wider];
        stride = wider;
    }

    private void substitute() {
        for (int i = 0; i < active; i++) {
            trial[i] = approach[set[i]];
        }
        for (int k = 0; k < active; k++) {
            int column = k * stride;
            trial[k] /= factor[column + k];
            for (int i = k + 1; i < active; i++) {
                trial[i] -= factor[column + i] * trial[k];
            }
        }
        for (int i = active - 1; i >= 0; i--) {
            int column = i * stride;
            double sum = trial[i];
            for (int k = i + 1; k < active; k++) {
                sum -= factor[column + k] * trial[k];
            }
            trial[i] = sum / factor[column + i];
        }
    }

    /** A_kl. */
    private double coupling(Bodies bodies, int k, int l) {
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
