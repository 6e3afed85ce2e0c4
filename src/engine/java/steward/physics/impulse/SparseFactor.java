package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;

/*
 * L D L' of the matrix P (A_SS + r diag(A) + B) P', where S are the contacts of the set, B is a given diagonal, and P
 * the order of elimination; a contact outside has the row of the identity. Row by row, as T. A. Davis, "Algorithm 849:
 * a concise sparse Cholesky factorization package", ACM Transactions on Mathematical Software 31, 2005: row i of L
 * solves a triangular system with the rows before it, and its entries are those on the paths of the elimination tree
 * from the entries of A in row i up to i. So the entries are the same for each set, and a contact that enters, leaves
 * or turns changes only the rows on its own path to the root.
 */

/**
 * Cholesky factor of the couplings of a system's contacts, in the order of {@link ContactOrder}, for sets of them. The
 * share {@value #REGULAR} is added to the diagonal, so that a factor exists for dependent normals, too.
 */
final class SparseFactor {

    /** Far above the rounding of pivots, and so small that a solution is refined by nine digits at a time. */
    private static final double REGULAR = 0x1p-30;

    /** Entries of a row of the factor for which there is room from the beginning. */
    private static final int USUAL = 16;

    private final ContactOrder order = new ContactOrder();
    private InelasticSystem system;
    private int size;
    /** Place of a contact in the order. */
    private int[] rank = new int[0];
    /** Rows of A below the diagonal: columns of row i from rowStart[i] on. */
    private int[] rowStart = new int[1];
    private int[] rowColumn = new int[0];
    /** Contacts of a body: from bodyStart on. */
    private int[] bodyStart = new int[0];
    private int[] bodyContact = new int[0];
    private int[] parent = new int[0];
    private int[] seen = new int[0];
    private int[] path = new int[0];
    /** Columns of row i of L from factorStart[i] on, in an order in which they can be computed. */
    private int[] factorStart = new int[1];
    private int[] factorColumn = new int[0];
    /** Places of these entries in the columns of L. */
    private int[] factorPlace = new int[0];
    /** Columns of L: rows and values from columnStart on, rows ascending. */
    private int[] columnStart = new int[1];
    private int[] columnRow = new int[0];
    private double[] value = new double[0];
    private double[] diagonal = new double[0];
    /** Of a contact: is added to its diagonal, besides its share. */
    private double[] added = new double[0];
    private double[] work = new double[0];
    private boolean[] stale = new boolean[0];

    /** Finds the entries of the factor of a system's contacts; all rows are to be computed. */
    void analyse(Bodies bodies, InelasticSystem ofSystem) {
        system = ofSystem;
        size = system.size;
        order.find(bodies, system);
        grow(bodies);
        for (int i = 0; i < size; i++) {
            rank[order.order[i]] = i;
        }
        findRows(bodies);
        findEntries();
    }

    private void grow(Bodies bodies) {
        if (rank.length < size) {
            int capacity = Math.max(2 * size, 3 * bodies.capacity());
            rank = new int[capacity];
            rowStart = new int[capacity + 1];
            parent = new int[capacity];
            seen = new int[capacity];
            path = new int[capacity];
            factorStart = new int[capacity + 1];
            columnStart = new int[capacity + 1];
            diagonal = new double[capacity];
            added = new double[capacity];
            work = new double[capacity];
            stale = new boolean[capacity];
            bodyContact = new int[2 * capacity];
        }
        if (bodyStart.length < bodies.size() + 2) {
            bodyStart = new int[bodies.capacity() + 2];
        }
        Arrays.fill(stale, 0, size, true);
    }

    private void findRows(Bodies bodies) {
        Arrays.fill(bodyStart, 0, bodies.size() + 2, 0);
        for (int k = 0; k < size; k++) {
            bodyStart[system.a[k] + 2]++;
            if (system.b[k] >= 0) {
                bodyStart[system.b[k] + 2]++;
            }
        }
        for (int i = 2; i < bodies.size() + 2; i++) {
            bodyStart[i] += bodyStart[i - 1];
        }
        for (int k = 0; k < size; k++) {
            bodyContact[bodyStart[system.a[k] + 1]++] = k;
            if (system.b[k] >= 0) {
                bodyContact[bodyStart[system.b[k] + 1]++] = k;
            }
        }
        int entries = 0;
        for (int i = 0; i < size; i++) {
            rowStart[i] = entries;
            int k = order.order[i];
            entries = addRow(bodies, i, system.a[k], entries);
            if (system.b[k] >= 0) {
                entries = addRow(bodies, i, system.b[k], entries);
            }
        }
        rowStart[size] = entries;
    }

    private int addRow(Bodies bodies, int i, int body, int from) {
        int entries = from;
        if (bodies.inverseMass[body] > 0) {
            for (int at = bodyStart[body]; at < bodyStart[body + 1]; at++) {
                int j = rank[bodyContact[at]];
                if (j < i) {
                    if (entries == rowColumn.length) {
                        rowColumn = Arrays.copyOf(rowColumn, 2 * entries + 4 * rank.length);
                    }
                    rowColumn[entries++] = j;
                }
            }
        }
        return entries;
    }

    private void findEntries() {
        Arrays.fill(columnStart, 0, size + 1, 0);
        int entries = 0;
        for (int i = 0; i < size; i++) {
            parent[i] = -1;
            seen[i] = i;
            factorStart[i] = entries;
            int top = size;
            for (int at = rowStart[i]; at < rowStart[i + 1]; at++) {
                int length = 0;
                for (int j = rowColumn[at]; seen[j] != i; j = parent[j]) {
                    parent[j] = parent[j] < 0 ? i : parent[j];
                    path[length++] = j;
                    seen[j] = i;
                }
                while (length > 0) {
                    path[--top] = path[--length];
                }
            }
            if (factorColumn.length < entries + size - top) {
                factorColumn = Arrays.copyOf(factorColumn, 2 * factorColumn.length + USUAL * rank.length);
            }
            for (; top < size; top++) {
                columnStart[path[top] + 1]++;
                factorColumn[entries++] = path[top];
            }
        }
        factorStart[size] = entries;
        if (factorPlace.length < entries) {
            factorPlace = new int[factorColumn.length];
            columnRow = new int[factorColumn.length];
            value = new double[factorColumn.length];
        }
        for (int j = 0; j < size; j++) {
            columnStart[j + 1] += columnStart[j];
            path[j] = columnStart[j];
        }
        for (int i = 0; i < size; i++) {
            for (int at = factorStart[i]; at < factorStart[i + 1]; at++) {
                int place = path[factorColumn[at]]++;
                factorPlace[at] = place;
                columnRow[place] = i;
            }
        }
    }

    /** Adds a number to the diagonal of a contact, instead of the one before. */
    void add(int k, double number) {
        if (added[k] != number) {
            added[k] = number;
            change(k);
        }
    }

    /** Takes note that a contact has entered or left the set, or has another normal. */
    void change(int k) {
        for (int i = rank[k]; i >= 0 && !stale[i]; i = parent[i]) {
            stale[i] = true;
        }
    }

    /** Computes the rows that have changed since the last time. */
    void factorize(Bodies bodies, boolean[] active) {
        for (int i = 0; i < size; i++) {
            if (stale[i]) {
                stale[i] = false;
                computeRow(bodies, active, i);
            }
        }
    }

    private void computeRow(Bodies bodies, boolean[] active, int i) {
        int k = order.order[i];
        double pivot = 1;
        if (active[k]) {
            for (int at = rowStart[i]; at < rowStart[i + 1]; at++) {
                int l = order.order[rowColumn[at]];
                work[rowColumn[at]] = active[l] ? system.coupling(bodies, k, l) : 0;
            }
            pivot = system.coupling(bodies, k, k) * (1 + REGULAR) + added[k];
        }
        for (int at = factorStart[i]; at < factorStart[i + 1]; at++) {
            int j = factorColumn[at];
            int place = factorPlace[at];
            double entry = work[j];
            double share = 0;
            if (entry != 0) {
                work[j] = 0;
                for (int below = columnStart[j]; below < place; below++) {
                    work[columnRow[below]] -= value[below] * entry;
                }
                share = entry / diagonal[j];
                pivot -= share * entry;
            }
            value[place] = share;
        }
        diagonal[i] = pivot;
    }

    /** Solves for a right side by contacts, in place; those outside the set keep theirs. */
    void solve(double[] side) {
        for (int i = 0; i < size; i++) {
            work[i] = side[order.order[i]];
        }
        for (int j = 0; j < size; j++) {
            double known = work[j];
            if (known != 0) {
                for (int at = columnStart[j]; at < columnStart[j + 1]; at++) {
                    work[columnRow[at]] -= value[at] * known;
                }
            }
        }
        for (int j = size - 1; j >= 0; j--) {
            double sum = work[j] / diagonal[j];
            for (int at = columnStart[j]; at < columnStart[j + 1]; at++) {
                sum -= value[at] * work[columnRow[at]];
            }
            work[j] = sum;
        }
        for (int i = 0; i < size; i++) {
            side[order.order[i]] = work[i];
            work[i] = 0;
        }
    }
}
