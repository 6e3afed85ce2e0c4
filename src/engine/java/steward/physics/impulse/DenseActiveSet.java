package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;

/**
 * Solver for the least impulses of a few contacts ({@link InelasticSystem}): non-negative least squares. Source: C. L.
 * Lawson, R. J. Hanson, "Solving Least Squares Problems", 1974, chapter 23. The contact that approaches most enters the
 * set; the set is solved by Cholesky; contacts whose impulse would be negative leave it. A contact whose normal depends
 * on those of the set (its pivot vanishes) stays out: what is left of its approach is rounding, or it is squeezed.
 * Contacts may be added to a solved system, which goes on from its set. The order of the contacts decides ties. Bound:
 * {@value #ROUNDS} entries per contact.
 */
final class DenseActiveSet {

    /** Bound on the entries of a contact into the set, on average. */
    private static final int ROUNDS = 4;
    /** A pivot below this share of the diagonal has vanished. */
    private static final double VANISHED = 0x1p-36;
    /** A normal depends on another only if its share of it is above this, not by rounding. */
    private static final double DEPENDENT = 0x1p-30;
    private static final int STRIDE = InelasticSystem.MOST_DENSE;

    private final InelasticSystem system;
    private final double[] trial = new double[InelasticSystem.MOST_DENSE];
    private final boolean[] blocked = new boolean[InelasticSystem.MOST_DENSE];
    private final int[] set = new int[InelasticSystem.MOST_DENSE];
    /** Columns of the Cholesky factor of the set: row i of column k at k * STRIDE + i. */
    private final double[] factor = new double[STRIDE * STRIDE];
    /** A row of the factor while it is computed. */
    private final double[] row = new double[STRIDE];
    private int active;
    private int entries;

    DenseActiveSet(InelasticSystem system) {
        this.system = system;
    }

    /** Takes note of a contact without an impulse. */
    void enter(int k) {
        blocked[k] = false;
        entries += ROUNDS;
    }

    /** Forgets the set. */
    void clear() {
        active = 0;
        entries = 0;
    }

    /** Begins from the set that there is, with other normals. @return false if it no longer is one */
    boolean resume(Bodies bodies) {
        Arrays.fill(blocked, 0, system.size, false);
        entries += ROUNDS;
        if (active == 0 || !factorize(bodies, 0)) {
            return false;
        }
        descend(bodies);
        return true;
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
                    system.impulse[next] = 0;
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
        for (int k = 0; k < system.size; k++) {
            if (system.impulse[k] == 0 && !blocked[k]) {
                double left = system.left(k);
                left = system.held[k] ? Math.abs(left) : left;
                if (left > speed) {
                    speed = left;
                    most = k;
                }
            }
        }
        return most;
    }

    private void move(Bodies bodies) {
        system.reset();
        for (int l = 0; l < active; l++) {
            system.apply(bodies, set[l]);
        }
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
            int column = i * STRIDE;
            double sum = factor[column + last];
            for (int k = i + 1; k < last; k++) {
                sum -= factor[column + k] * trial[k];
            }
            trial[i] = sum / factor[column + i];
        }
        int leaves = -1;
        double least = 0;
        for (int l = 0; l < last; l++) {
            double until = system.impulse[set[l]] / trial[l];
            if (trial[l] > DEPENDENT && !system.held[set[l]] && (leaves < 0 || until < least)) {
                least = until;
                leaves = l;
            }
        }
        if (leaves < 0) {
            return leaves;
        }
        for (int l = 0; l < last; l++) {
            double j = system.impulse[set[l]] - least * trial[l];
            system.impulse[set[l]] = system.held[set[l]] ? j : Math.max(0, j);
        }
        system.impulse[set[last]] += least;
        leave(leaves);
        return leaves;
    }

    private void leave(int l) {
        system.impulse[set[l]] = 0;
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
                if (!(trial[l] > 0) && !system.held[k]) {
                    double until = system.impulse[k] / (system.impulse[k] - trial[l]);
                    if (leaves < 0 || until < share) {
                        share = until;
                        leaves = l;
                    }
                }
            }
            for (int l = 0; l < active; l++) {
                int k = set[l];
                system.impulse[k] = leaves < 0 ? trial[l] : system.impulse[k] + share * (trial[l] - system.impulse[k]);
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
        for (int i = from; i < active; i++) {
            for (int j = 0; j <= i; j++) {
                row[j] = system.coupling(bodies, set[i], set[j]);
            }
            double whole = row[i];
            for (int k = 0; k < i; k++) {
                int column = k * STRIDE;
                double share = row[k] / factor[column + k];
                factor[column + i] = share;
                if (share != 0) {
                    takeOff(column, share, k + 1, i + 1);
                }
            }
            if (!(row[i] > VANISHED * whole)) {
                return false;
            }
            factor[i * STRIDE + i] = Math.sqrt(row[i]);
        }
        return true;
    }

    private void takeOff(int column, double share, int from, int to) {
        for (int j = from; j < to; j++) {
            row[j] -= share * factor[column + j];
        }
    }

    private void substitute() {
        for (int i = 0; i < active; i++) {
            trial[i] = system.before(set[i]);
        }
        for (int k = 0; k < active; k++) {
            int column = k * STRIDE;
            trial[k] /= factor[column + k];
            for (int i = k + 1; i < active; i++) {
                trial[i] -= factor[column + i] * trial[k];
            }
        }
        for (int i = active - 1; i >= 0; i--) {
            int column = i * STRIDE;
            double sum = trial[i];
            for (int k = i + 1; k < active; k++) {
                sum -= factor[column + k] * trial[k];
            }
            trial[i] = sum / factor[column + i];
        }
    }
}
