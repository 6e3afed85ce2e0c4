package steward.physics.impulse;

import steward.physics.Bodies;

/*
 * At the minimum, impulses j >= 0 and the speeds w = A j - u >= 0 at which contacts open have the products j w = 0. On
 * the way there all are positive, and each product is near to the mean m. A step of Newton's method towards products of
 * s m solves
 *
 *     A dj - dw = u - A j + w,   w dj + j dw = s m - j w - e,   so   (A + w / j) dj = u - A j + (s m - e) / j,
 *
 * twice with one factor: with s = 0 and e = 0 to see how far that leads, then with s the cube of the share of m that
 * this would leave, and with the products e = dj dw that it has neglected. It takes one step for about each digit of
 * the ratio of m to its beginning, whatever the number of contacts. Impulses of dependent contacts are shared out:
 * where the minimum allows it, all of them are positive, so the set has no doubtful contact.
 */

/**
 * Interior point method for the least impulses of many contacts ({@link InelasticSystem}): it finds which of them carry
 * where {@link SparseActiveSet} does not. Source: S. Mehrotra, "On the implementation of a primal-dual interior point
 * method", SIAM Journal on Optimization 2, 1992.
 */
final class InteriorPoint {

    /** Bound on steps: heaps with masses from 1 to 1,000,000 take 30, contacts that contradict each other never end. */
    private static final int MOST_STEPS = 60;
    /** Share of the way to the first impulse or speed of 0. */
    private static final double INSIDE = 0.995;

    private final InelasticSystem system;
    private final SparseFactor factor;
    /** Speeds at which contacts open, and their changes. */
    private double[] opening = new double[0];
    private double[] openingChange = new double[0];
    /** Changes of impulses by the first solution, then by the second one. */
    private double[] ahead = new double[0];
    private double[] change = new double[0];
    /** Contacts that may open, and the mean of their products of impulse and speed. */
    private int free;
    private double mean;

    InteriorPoint(InelasticSystem system, SparseFactor factor) {
        this.system = system;
        this.factor = factor;
    }

    /**
     * Finds the contacts that carry; their impulses are near to the least ones, those of others are 0.
     *
     * @param active the contacts that carry
     * @param speed the largest approach
     * @param end the ratio of the mean product to its beginning at which it stops
     */
    void find(Bodies bodies, boolean[] active, double speed, double end) {
        begin(bodies, active, speed);
        double last = end * mean;
        for (int steps = 0; steps < MOST_STEPS && mean > last; steps++) {
            step(bodies, active);
        }
        for (int k = 0; k < system.size; k++) {
            factor.add(k, 0);
            boolean carries = system.held[k] || system.impulse[k] * system.coupling(bodies, k, k) > opening[k];
            if (!carries) {
                active[k] = false;
                system.impulse[k] = 0;
            }
        }
        system.move(bodies);
    }

    private void begin(Bodies bodies, boolean[] active, double speed) {
        if (opening.length < active.length) {
            opening = new double[active.length];
            openingChange = new double[active.length];
            ahead = new double[active.length];
            change = new double[active.length];
        }
        for (int k = 0; k < system.size; k++) {
            active[k] = true;
            system.impulse[k] = system.held[k] ? 0 : speed / system.coupling(bodies, k, k);
            opening[k] = system.held[k] ? 0 : speed;
        }
        system.move(bodies);
        findMean();
    }

    private void findMean() {
        free = 0;
        mean = 0;
        for (int k = 0; k < system.size; k++) {
            if (!system.held[k]) {
                free++;
                mean += system.impulse[k] * opening[k];
            }
        }
        mean /= Math.max(1, free);
    }

    private void step(Bodies bodies, boolean[] active) {
        for (int k = 0; k < system.size; k++) {
            factor.add(k, system.held[k] ? 0 : opening[k] / system.impulse[k]);
            ahead[k] = system.left(k);
            change[k] = ahead[k];
        }
        factor.factorize(bodies, active);
        factor.solve(ahead);
        double share = mean == 0 ? 0 : meanAhead() / mean;
        double aim = share * share * share * mean;
        for (int k = 0; k < system.size; k++) {
            if (!system.held[k]) {
                openingChange[k] = (aim - ahead[k] * openingChange[k]) / system.impulse[k];
                change[k] += openingChange[k];
            }
        }
        factor.solve(change);
        for (int k = 0; k < system.size; k++) {
            openingChange[k] -= system.held[k] ? 0 : opening[k] + opening[k] / system.impulse[k] * change[k];
        }
        double step = Math.min(1, INSIDE * longest(change));
        for (int k = 0; k < system.size; k++) {
            system.impulse[k] += step * change[k];
            opening[k] += system.held[k] ? 0 : step * openingChange[k];
        }
        system.move(bodies);
        findMean();
    }

    /** Finds the changes of the speeds by the first solution. @return the mean product that they would leave */
    private double meanAhead() {
        for (int k = 0; k < system.size; k++) {
            openingChange[k] = system.held[k] ? 0 : -opening[k] - opening[k] / system.impulse[k] * ahead[k];
        }
        double step = Math.min(1, longest(ahead));
        double sum = 0;
        for (int k = 0; k < system.size; k++) {
            if (!system.held[k]) {
                sum += (system.impulse[k] + step * ahead[k]) * (opening[k] + step * openingChange[k]);
            }
        }
        return sum / Math.max(1, free);
    }

    /** The share of a step at which the first impulse or speed would be 0. */
    private double longest(double[] by) {
        double step = Double.POSITIVE_INFINITY;
        for (int k = 0; k < system.size; k++) {
            if (!system.held[k]) {
                step = by[k] < 0 ? Math.min(step, -system.impulse[k] / by[k]) : step;
                step = openingChange[k] < 0 ? Math.min(step, -opening[k] / openingChange[k]) : step;
            }
        }
        return step;
    }
}
