package steward.physics.impulse;

import steward.physics.Bodies;

/*
 * Contacts k with normals n_k from a_k to b_k and approach speeds u_k = n_k.(va - vb); impulses j_k >= 0 along them
 * change u by -A j, A_kl the sum over shared bodies of the signs times w n_k.n_l. Wanted are the least impulses after
 * which nothing approaches, u' = u - A j <= 0, with j_k > 0 only where u'_k = 0 (Moreau's inelastic impact): the
 * velocities nearest to the old ones, measured by the kinetic energy, among those that do not approach. So the energy
 * never rises, and the velocities are unique even if the impulses are not.
 *
 * Solved by active sets, as non-negative least squares (C. L. Lawson, R. J. Hanson, "Solving Least Squares Problems",
 * 1974, chapter 23): the contact that approaches most enters the set; the set is solved by Cholesky; contacts whose
 * impulse would be negative leave it. A contact whose normal depends on those of the set (its pivot vanishes) stays
 * out: what is left of its approach is rounding, or it is squeezed.
 */

/**
 * The impulses that end the approach in a system of contacts, and no more. The order of the contacts decides ties.
 * Bounds: {@value #MOST} contacts, {@value #ROUNDS} entries per contact. Residual: see {@link #residual}.
 */
final class InelasticSystem {

    /** The most contacts in a system. */
    static final int MOST = 192;
    /** How often a contact may enter the set, on the average. */
    private static final int ROUNDS = 4;
    /** A pivot below this share of the diagonal has vanished. */
    private static final double VANISHED = 0x1p-36;

    int size;
    final int[] a = new int[MOST];
    /** Another body, or {@code ~wall}. */
    final int[] b = new int[MOST];
    final double[] normalX = new double[MOST];
    final double[] normalY = new double[MOST];
    final double[] impulse = new double[MOST];
    /** The approach speed that a contact may keep, because it has a gap. */
    final double[] allowed = new double[MOST];
    private final double[] approach = new double[MOST];
    private final double[] trial = new double[MOST];
    private final boolean[] blocked = new boolean[MOST];
    private final int[] set = new int[MOST];
    private final double[] factor = new double[MOST * (MOST + 1) / 2];
    private int active;

    void add(int body, int other, double nx, double ny) {
        allowed[size] = 0;
        a[size] = body;
        b[size] = other;
        normalX[size] = nx;
        normalY[size] = ny;
        size++;
    }

    /** Exchanges two contacts. */
    void swap(int k, int l) {
        int body = a[k];
        int other = b[k];
        double nx = normalX[k];
        double ny = normalY[k];
        double kept = allowed[k];
        allowed[k] = allowed[l];
        allowed[l] = kept;
        a[k] = a[l];
        b[k] = b[l];
        normalX[k] = normalX[l];
        normalY[k] = normalY[l];
        a[l] = body;
        b[l] = other;
        normalX[l] = nx;
        normalY[l] = ny;
    }

    /** The approach speed of a contact. */
    double approach(Bodies bodies, int k) {
        double x = bodies.vx[a[k]];
        double y = bodies.vy[a[k]];
        if (b[k] >= 0) {
            x -= bodies.vx[b[k]];
            y -= bodies.vy[b[k]];
        }
        return normalX[k] * x + normalY[k] * y;
    }

    /**
     * Computes the impulses after which every contact separates at least at a speed, or has no more approach than it is
     * allowed.
     *
     * @param parting   the speed, at least 0
     * @param tolerance an approach up to this speed remains
     * @return false if a contact cannot part, or the bound on entries was reached
     */
    boolean solve(Bodies bodies, double parting, double tolerance) {
        active = 0;
        boolean parts = true;
        for (int k = 0; k < size; k++) {
            approach[k] = approach(bodies, k) + (allowed[k] > 0 ? -allowed[k] : parting);
            impulse[k] = 0;
            blocked[k] = false;
        }
        for (int entries = ROUNDS * size; entries > 0; entries--) {
            int next = mostApproaching(bodies, tolerance);
            if (next < 0) {
                return parts;
            }
            set[active++] = next;
            if (!factorize(bodies)) {
                active--;
                blocked[next] = true;
                parts = false;
            } else {
                descend(bodies);
            }
        }
        return false;
    }

    private int mostApproaching(Bodies bodies, double tolerance) {
        int most = -1;
        double speed = tolerance;
        for (int k = 0; k < size; k++) {
            if (impulse[k] == 0 && !blocked[k]) {
                double left = approach[k];
                for (int l = 0; l < active; l++) {
                    left -= coupling(bodies, k, set[l]) * impulse[set[l]];
                }
                if (left > speed) {
                    speed = left;
                    most = k;
                }
            }
        }
        return most;
    }

    /** Moves to the solution of the set, from edge to edge while an impulse would become negative. */
    private void descend(Bodies bodies) {
        for (;;) {
            substitute();
            double share = 1;
            int leaves = -1;
            for (int l = 0; l < active; l++) {
                int k = set[l];
                if (!(trial[l] > 0)) {
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
            impulse[set[leaves]] = 0;
            active--;
            System.arraycopy(set, leaves + 1, set, leaves, active - leaves);
            if (active == 0 || !factorize(bodies)) {
                return;
            }
        }
    }

    /** The Cholesky factor of the set. @return false if a pivot vanishes */
    private boolean factorize(Bodies bodies) {
        for (int i = 0; i < active; i++) {
            int row = i * (i + 1) / 2;
            for (int j = 0; j <= i; j++) {
                double sum = coupling(bodies, set[i], set[j]);
                double whole = sum;
                int other = j * (j + 1) / 2;
                for (int k = 0; k < j; k++) {
                    sum -= factor[row + k] * factor[other + k];
                }
                if (i != j) {
                    factor[row + j] = sum / factor[other + j];
                } else if (sum > VANISHED * whole) {
                    factor[row + i] = Math.sqrt(sum);
                } else {
                    return false;
                }
            }
        }
        return true;
    }

    private void substitute() {
        for (int i = 0; i < active; i++) {
            int row = i * (i + 1) / 2;
            double sum = approach[set[i]];
            for (int k = 0; k < i; k++) {
                sum -= factor[row + k] * trial[k];
            }
            trial[i] = sum / factor[row + i];
        }
        for (int i = active - 1; i >= 0; i--) {
            double sum = trial[i];
            for (int k = i + 1; k < active; k++) {
                sum -= factor[k * (k + 1) / 2 + i] * trial[k];
            }
            trial[i] = sum / factor[i * (i + 1) / 2 + i];
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

    /** The largest approach speed that is left: some units of 2^-50 of the speeds, unless something is squeezed. */
    double residual(Bodies bodies) {
        double most = 0;
        for (int k = 0; k < size; k++) {
            most = Math.max(most, approach(bodies, k));
        }
        return most;
    }
}
