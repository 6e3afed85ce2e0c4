package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;

/**
 * Order in which the contacts of a system are eliminated: nested dissection of the plane. Source: A. George, "Nested
 * dissection of a regular finite element mesh", SIAM Journal on Numerical Analysis 10, 1973. Contacts are halved at the
 * median of the longer side of their box; those of the lower half that share a body with the other half separate the
 * rest of both, and come last. Places alone decide; the order of contacts decides ties.
 */
final class ContactOrder {

    /** So few contacts stay as they are. */
    private static final int LEAF = 8;

    /** Contacts in the order of elimination. */
    int[] order = new int[0];
    private int[] buffer = new int[0];
    private double[] x = new double[0];
    private double[] y = new double[0];
    /** Of a body, the last half in whose dissection it had a contact on the upper side. */
    private int[] mark = new int[0];
    private int half;
    private Bodies bodies;
    /** Bodies of contacts, as in {@link InelasticSystem}. */
    private int[] a;
    private int[] b;

    /** Finds the order of contacts of the bodies {@code first} and {@code second}. */
    void find(Bodies ofBodies, int[] first, int[] second, int size) {
        bodies = ofBodies;
        a = first;
        b = second;
        if (order.length < size) {
            int capacity = Math.max(2 * size, 3 * bodies.capacity());
            order = new int[capacity];
            buffer = new int[capacity];
            x = new double[capacity];
            y = new double[capacity];
        }
        if (mark.length < bodies.size()) {
            mark = new int[bodies.capacity()];
        }
        Arrays.fill(mark, 0, bodies.size(), 0);
        half = 0;
        for (int k = 0; k < size; k++) {
            int other = b[k] < 0 ? a[k] : b[k];
            order[k] = k;
            x[k] = bodies.x[a[k]] + bodies.x[other];
            y[k] = bodies.y[a[k]] + bodies.y[other];
        }
        dissect(0, size);
    }

    private void dissect(int from, int to) {
        if (to - from <= LEAF) {
            return;
        }
        int middle = (from + to) >>> 1;
        select(from, to - 1, middle, isWide(from, to) ? x : y);
        half++;
        for (int p = middle; p < to; p++) {
            mark(a[order[p]]);
            if (b[order[p]] >= 0) {
                mark(b[order[p]]);
            }
        }
        int lower = from;
        int separating = 0;
        for (int p = from; p < middle; p++) {
            int k = order[p];
            if (mark[a[k]] == half || b[k] >= 0 && mark[b[k]] == half) {
                buffer[separating++] = k;
            } else {
                order[lower++] = k;
            }
        }
        System.arraycopy(order, middle, order, lower, to - middle);
        System.arraycopy(buffer, 0, order, to - separating, separating);
        dissect(from, lower);
        dissect(lower, to - separating);
    }

    /** An infinite mass couples nothing. */
    private void mark(int body) {
        if (bodies.inverseMass[body] > 0) {
            mark[body] = half;
        }
    }

    private boolean isWide(int from, int to) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int p = from; p < to; p++) {
            left = Math.min(left, x[order[p]]);
            right = Math.max(right, x[order[p]]);
            low = Math.min(low, y[order[p]]);
            high = Math.max(high, y[order[p]]);
        }
        return right - left >= high - low;
    }

    /** Puts the contact of a rank in its place, those below before it (C. A. R. Hoare's selection, 1961). */
    private void select(int from, int to, int rank, double[] by) {
        int low = from;
        int high = to;
        while (low < high) {
            int pivot = order[(low + high) >>> 1];
            int i = low;
            int j = high;
            while (i <= j) {
                while (isBefore(order[i], pivot, by)) {
                    i++;
                }
                while (isBefore(pivot, order[j], by)) {
                    j--;
                }
                if (i <= j) {
                    int kept = order[i];
                    order[i++] = order[j];
                    order[j--] = kept;
                }
            }
            if (rank <= j) {
                high = j;
            } else if (rank >= i) {
                low = i;
            } else {
                return;
            }
        }
    }

    private static boolean isBefore(int k, int l, double[] by) {
        return by[k] < by[l] || by[k] == by[l] && k < l;
    }
}
