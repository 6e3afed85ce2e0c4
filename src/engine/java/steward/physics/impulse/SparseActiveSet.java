package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;

/*
 * Block pivoting (J. J. Judice, F. M. Pires, "A block principal pivoting algorithm for large-scale strictly monotone
 * linear complementarity problems", Computers & Operations Research 21, 1994): solve the set, then let all contacts
 * leave whose impulse is negative and all enter that approach. It takes a few steps, or does not end. So once it fails
 * to lower the number of wrong contacts, each step has to lessen j A j / 2 - u j: along the edges where impulses become
 * 0, with the slope of contacts that carry or approach scaled by the factor (D. P. Bertsekas, "Projected Newton methods
 * for optimization problems with simple constraints", SIAM Journal on Control and Optimization 20, 1982), or up to the
 * first edge, as in non-negative least squares. That ends, since each set has one minimum.
 *
 * With dependent normals A is only semidefinite. So a step solves with A + r D, D the diagonal of A: the minimum of
 * j A j / 2 - u j + r (j - c) D (j - c) / 2 for the impulses c before the step. Repeated, that goes on to a minimum
 * without r (R. T. Rockafellar, "Monotone operators and the proximal point algorithm", SIAM Journal on Control and
 * Optimization 14, 1976), by a factor r / (eigenvalue + r) at a time. It is iterative refinement as well: what is left
 * of approaches is always computed from the impulses.
 */

/**
 * Solver for the least impulses of many contacts ({@link InelasticSystem}). Begins with the guess that closed
 * contacts carry, and those that approach faster than they may; such contacts that are added join the set.
 */
final class SparseActiveSet {

    /** Exchanges of all contacts at once that may fail to lower the number of wrong ones, before one at a time. */
    private static final int CHANCES = 4;
    /** Share of the diagonal that is added on the way down: sets whose contacts contradict each other stay near. */
    private static final double COARSE = 0x1p-14;
    /** Steps on the way down between one share and the other: large ratios of masses want the finer one. */
    private static final int TURNS = 64;
    /** Bound on steps, besides four for each contact. */
    private static final int MOST_STEPS = 200;
    /** The least share of a step along edges. */
    private static final double LEAST_SHARE = 0.25;
    /** Speeds that remain in a set, as a share of the largest approach: rounding. */
    private static final double ROUNDING = 0x1p-48;
    /** Speeds that may remain as a share of the largest change of a velocity: rounding, where these cancel. */
    private static final double CHANGES = 0.75 * 0x1p-50;
    /** Refinements that lessen what remains by less than a half, at most, before contacts are said not to part. */
    private static final int SLOW = 24;

    private final InelasticSystem system;
    private final SparseFactor factor = new SparseFactor();
    private boolean[] active = new boolean[0];
    /** Impulses before a step. */
    private double[] start = new double[0];
    /** Speeds that were left of approaches before a step. */
    private double[] slope = new double[0];
    /** Right side, then the change of the impulses. */
    private double[] change = new double[0];
    /** Contacts that the factor knows; 0 for none. */
    private int known;

    SparseActiveSet(InelasticSystem system) {
        this.system = system;
    }

    /** Forgets all contacts. */
    void forget() {
        known = 0;
    }

    /** Begins with a new guess. */
    void restart() {
        for (int k = 0; k < known; k++) {
            set(k, isGuessed(k));
        }
    }

    /** True for contacts that are closed, or approach at the velocities that there are. */
    private boolean isGuessed(int k) {
        return system.allowed[k] == 0 || system.left(k) > 0;
    }

    /** Takes note that a contact has another normal. */
    void turn(int k) {
        if (k < known) {
            factor.change(k);
        }
    }

    private void set(int k, boolean carries) {
        if (active[k] != carries) {
            active[k] = carries;
            factor.change(k);
        }
    }

    private void begin(Bodies bodies) {
        if (active.length < system.size) {
            int capacity = Math.max(2 * system.size, 3 * bodies.capacity());
            active = Arrays.copyOf(active, capacity);
            start = new double[capacity];
            slope = new double[capacity];
            change = new double[capacity];
        }
        if (known < system.size) {
            for (; known < system.size; known++) {
                active[known] = isGuessed(known);
            }
            factor.analyse(bodies, system);
        }
        for (int k = 0; k < known; k++) {
            set(k, active[k] || system.held[k]);
        }
        system.move(bodies);
    }

    /**
     * Computes the impulses.
     *
     * @param tolerance an approach up to this speed remains
     * @return false if a contact cannot part
     */
    boolean solve(Bodies bodies, double tolerance) {
        begin(bodies);
        double rounding = ROUNDING * largestApproach();
        double before = Double.POSITIVE_INFINITY;
        int fewest = Integer.MAX_VALUE;
        int chances = CHANCES;
        int slow = 0;
        factor.regularize(SparseFactor.REGULAR);
        for (int steps = 0; steps < MOST_STEPS + 4 * known; steps++) {
            if (chances == 0 && steps % TURNS == 0) {
                factor.regularize(steps / TURNS % 2 == 0 ? COARSE : SparseFactor.REGULAR);
            }
            solveSet(bodies);
            int wrong = 1;
            if (chances > 0) {
                go(bodies, 1, false);
                wrong = exchange(bodies, tolerance);
                chances = wrong == 0 ? chances : wrong < fewest ? CHANCES : chances - 1;
                fewest = Math.min(fewest, wrong);
                if (chances == 0) {
                    exchange(bodies, tolerance);
                    factor.regularize(COARSE);
                }
            } else if (descend(bodies)) {
                wrong = exchange(bodies, tolerance);
            }
            if (wrong > 0) {
                continue;
            }
            factor.regularize(SparseFactor.REGULAR);
            double left = mostLeft();
            slow += left > before / 2 ? 1 : 0;
            if (left <= rounding || slow > SLOW || left <= tolerance && slow > 0) {
                return left <= Math.max(tolerance, CHANGES * system.largestChange(bodies));
            }
            before = left;
        }
        return false;
    }

    private double largestApproach() {
        double largest = 0;
        for (int k = 0; k < known; k++) {
            largest = Math.max(largest, Math.abs(system.before(k)));
        }
        return largest;
    }

    /** Computes the change of the impulses that leads to the solution of the set. */
    private void solveSet(Bodies bodies) {
        factor.factorize(bodies, active);
        for (int k = 0; k < known; k++) {
            slope[k] = system.left(k);
            change[k] = active[k] ? slope[k] : 0;
        }
        factor.solve(change);
        System.arraycopy(system.impulse, 0, start, 0, known);
    }

    /**
     * Goes a share of the way to the solution of the set from {@link #start}.
     *
     * @param along whether impulses that would become negative stay 0
     * @return true if there was no such impulse
     */
    private boolean go(Bodies bodies, double share, boolean along) {
        boolean straight = true;
        for (int k = 0; k < known; k++) {
            double j = start[k] + share * change[k];
            boolean edge = along && j < 0 && !system.held[k];
            straight &= !edge;
            system.impulse[k] = edge ? 0 : j;
        }
        system.move(bodies);
        return straight;
    }

    /**
     * Goes towards the solution of the set, along the edges where impulses would become negative, if that is better; if
     * not, up to the first edge, and what would become negative there leaves the set.
     *
     * @return true in the first case
     */
    private boolean descend(Bodies bodies) {
        for (double share = 1; share >= LEAST_SHARE; share /= 2) {
            if (go(bodies, share, true) || gain() > 0) {
                return true;
            }
        }
        double share = 1;
        for (int k = 0; k < known; k++) {
            if (change[k] < 0 && !system.held[k]) {
                share = Math.min(share, start[k] / -change[k]);
            }
        }
        go(bodies, share, true);
        for (int k = 0; k < known; k++) {
            if (change[k] < 0 && !system.held[k] && start[k] <= share * -change[k]) {
                system.impulse[k] = 0;
                set(k, false);
            }
        }
        return false;
    }

    /** By how much a step lessens j A j / 2 - u j: that is the mean of both slopes along it. */
    private double gain() {
        double gain = 0;
        for (int k = 0; k < known; k++) {
            gain += (system.impulse[k] - start[k]) * (slope[k] + system.left(k)) / 2;
        }
        return gain;
    }

    /** Lets all contacts enter or leave that are wrong in the set or outside. @return how many they are */
    private int exchange(Bodies bodies, double tolerance) {
        int wrong = 0;
        for (int k = 0; k < known; k++) {
            boolean carries = system.held[k] || system.impulse[k] > 0
                || system.impulse[k] == 0 && system.left(k) > tolerance;
            if (carries != active[k]) {
                wrong++;
                set(k, carries);
            }
        }
        for (int k = 0; k < known; k++) {
            if (!active[k]) {
                system.impulse[k] = 0;
            }
        }
        if (wrong > 0) {
            system.move(bodies);
        }
        return wrong;
    }

    /** The most that is left of an approach, or of an opening, within the set. */
    private double mostLeft() {
        double most = 0;
        for (int k = 0; k < known; k++) {
            if (active[k]) {
                most = Math.max(most, Math.abs(system.left(k)));
            }
        }
        return most;
    }
}
