package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;

/*
 * Block pivoting (J. J. Judice, F. M. Pires, "A block principal pivoting algorithm for large-scale strictly monotone
 * linear complementarity problems", Computers & Operations Research 21, 1994): solve the set, then let all contacts
 * leave whose impulse is negative and all enter that approach. It takes a few steps, or does not end. So once it fails
 * to lower the number of wrong contacts, an interior point method finds the set, nearer to the minimum each time.
 *
 * With dependent normals A is only semidefinite. So a step solves with A + r D, D the diagonal of A: the minimum of
 * j A j / 2 - u j + r (j - c) D (j - c) / 2 for the impulses c before the step. Repeated, that goes on to a minimum
 * without r (R. T. Rockafellar, "Monotone operators and the proximal point algorithm", SIAM Journal on Control and
 * Optimization 14, 1976), by a factor r / (eigenvalue + r) at a time. It is iterative refinement as well: what is left
 * of approaches is always computed from the impulses.
 */

/**
 * Solver for the least impulses of many contacts ({@link InelasticSystem}). Begins with the guess that contacts carry
 * which are closed, or nearly so, unless the last system that had them left them out, and contacts with a gap that
 * approach faster than they may. Contacts that are closed or approach and are added later join the set. The first
 * solution is refined before contacts leave: its error is more than the impulse of some.
 */
final class SparseActiveSet {

    /** Exchanges of all contacts that may fail to lower the number of wrong ones. */
    private static final int CHANCES = 4;
    /** Bound on steps; up to 42 were seen. */
    private static final int MOST_STEPS = 400;
    /** Ratio of products at which the interior point method stops at first, from one time to the next, and at last. */
    private static final double NEAR = 1e-12;
    private static final double NEARER = 1e-3;
    private static final double NEAREST = 1e-26;
    /** A contact that may approach by less than this share of the largest approach is guessed to carry. */
    private static final double NEARLY = 0x1p-18;
    /** Speeds that remain in a set, as a share of the largest approach: rounding. */
    private static final double ROUNDING = 0x1p-48;
    /** Speeds that may remain as a share of the largest change of a velocity: rounding, where these cancel. */
    private static final double CHANGES = 0.75 * 0x1p-50;
    /** Refinements that lessen what remains by less than a half, at most, before contacts are said not to part. */
    private static final int SLOW = 24;

    private final InelasticSystem system;
    private final SparseFactor factor;
    private final InteriorPoint interior;
    private boolean[] active = new boolean[0];
    /** Right side, then the change of the impulses. */
    private double[] change = new double[0];
    /** Contacts of the system that the factor has; 0 if it has begun anew. */
    private int known;
    /** True if the set that there is has solved its system. */
    private boolean isFound;
    /** True if nothing was solved here since all impulses were 0. */
    private boolean begins;
    /** Contacts that may keep an approach up to this speed are guessed to carry. */
    private double nearly;

    SparseActiveSet(InelasticSystem system, SparseFactor factor) {
        this.system = system;
        this.factor = factor;
        interior = new InteriorPoint(system, factor);
    }

    /** Begins with other contacts. */
    void begin() {
        known = 0;
        isFound = false;
        begins = true;
    }

    /** Begins with impulses of 0, and with a new guess, unless the last set was a solution. */
    void restart() {
        for (int k = 0; k < known && !isFound; k++) {
            active[k] = isGuessed(k);
        }
        begins = true;
    }

    /** True for contacts that are closed or nearly so, or approach at the velocities that there are. */
    private boolean isGuessed(int k) {
        return system.allowed[k] <= nearly || system.left(k) > 0;
    }

    private void guess(Bodies bodies) {
        if (active.length < system.size) {
            int capacity = Math.max(2 * system.size, 3 * bodies.capacity());
            active = Arrays.copyOf(active, capacity);
            change = new double[capacity];
        }
        if (known < system.size) {
            factor.enter(bodies, known);
            boolean isFirst = known == 0;
            for (; known < system.size; known++) {
                boolean wasOut = isFirst && system.allowed[known] <= nearly && factor.wasOut(known);
                active[known] = isGuessed(known) && !wasOut;
            }
        }
        for (int k = 0; k < known; k++) {
            active[k] |= system.held[k];
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
        isFound = find(bodies, tolerance);
        return isFound;
    }

    private boolean find(Bodies bodies, double tolerance) {
        double speed = largestApproach();
        nearly = NEARLY * speed;
        guess(bodies);
        double near = NEAR;
        double before = Double.POSITIVE_INFINITY;
        int fewest = Integer.MAX_VALUE;
        int chances = CHANCES;
        int slow = 0;
        for (int steps = 0; steps < MOST_STEPS; steps++) {
            if (chances == 0 && near < NEAREST) {
                return false;
            }
            if (chances == 0) {
                interior.find(bodies, active, speed, near);
                near *= NEARER;
                fewest = Integer.MAX_VALUE;
                chances = CHANCES;
            }
            solveSet(bodies);
            if (begins) {
                begins = false;
                solveSet(bodies);
            }
            int wrong = exchange(bodies, tolerance);
            chances = wrong == 0 ? chances : wrong < fewest ? CHANCES : chances - 1;
            fewest = Math.min(fewest, wrong);
            if (wrong > 0) {
                continue;
            }
            double left = mostLeft();
            double exact = Math.max(tolerance, CHANGES * system.largestChange(bodies));
            slow += left > before / 2 ? 1 : 0;
            if (left <= ROUNDING * speed || slow > SLOW || left <= exact && slow > 0) {
                return left <= exact;
            }
            before = left;
        }
        return false;
    }

    private double largestApproach() {
        double largest = 0;
        for (int k = 0; k < system.size; k++) {
            largest = Math.max(largest, Math.abs(system.before(k)));
        }
        return largest;
    }

    /** Solves the set. */
    private void solveSet(Bodies bodies) {
        factor.factorize(bodies, active);
        for (int k = 0; k < known; k++) {
            change[k] = active[k] ? system.left(k) : 0;
        }
        factor.solve(change);
        for (int k = 0; k < known; k++) {
            system.impulse[k] += change[k];
        }
        system.move(bodies);
    }

    /** Lets all contacts enter or leave that are wrong in the set or outside. @return how many they are */
    private int exchange(Bodies bodies, double tolerance) {
        int wrong = 0;
        for (int k = 0; k < known; k++) {
            boolean carries = system.held[k] || system.impulse[k] > 0
                || system.impulse[k] == 0 && system.left(k) > tolerance;
            if (carries != active[k]) {
                wrong++;
                active[k] = carries;
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
