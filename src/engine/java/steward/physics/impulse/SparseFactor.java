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
 * share {@value #REGULAR} is added to the diagonal, so that a factor exists for dependent normals, too. It keeps all
 * contacts that it has met since bodies were last moved, so that systems of the bodies share what they have in common.
 */
final class SparseFactor {

    /** Far above the rounding of pivots, and so small that a solution is refined by nine digits at a time. */
    private static final double REGULAR = 0x1p-30;

    /** Entries of a row of the factor for which there is room from the beginning. */
    private static final int USUAL = 16;

    private final InelasticSystem system;
    private final ContactOrder order = new ContactOrder();
    /** Bodies of the contacts of these places, as in {@link InelasticSystem}. */
    private int[] a = new int[0];
    private int[] b = new int[0];
    /** Contacts of these places, and those of them that have a row. */
    private int size;
    private int rows;
    /** Of a body, its last contact as the first of the two, or -1; and of a contact, the one before it. */
    private int[] last = new int[0];
    private int[] previous = new int[0];
    /** Of a contact of the system, its index here. */
    private int[] index = new int[0];
    /** Of a contact, its index in the system, or -1. */
    private int[] inSystem = new int[0];
    /** True for a contact that its last system before the present one has left out of its set. */
    private boolean[] wasOut = new boolean[0];
    /** Of a contact: is in the set, its normal and what is added to its diagonal, as its row has them. */
    private boolean[] inSet = new boolean[0];
    private double[] normalX = new double[0];
    private double[] normalY = new double[0];
    private double[] added = new double[0];
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
    private double[] work = new double[0];
    private boolean[] stale = new boolean[0];

    SparseFactor(InelasticSystem system) {
        this.system = system;
    }

    /** Forgets all contacts: bodies have moved. */
    void forget(Bodies bodies) {
        if (last.length < bodies.size()) {
            last = new int[bodies.capacity()];
            Arrays.fill(last, -1);
        }
        for (int p = 0; p < size; p++) {
            last[a[p]] = -1;
        }
        size = 0;
        rows = 0;
    }

    /** Takes note that a system of these places may have a contact. @return its index */
    int expect(int body, int other) {
        for (int p = last[body]; p >= 0; p = previous[p]) {
            if (b[p] == other) {
                return p;
            }
        }
        if (size == a.length) {
            grow(Math.max(2 * size, 3 * last.length));
        }
        a[size] = body;
        b[size] = other;
        previous[size] = last[body];
        last[body] = size;
        inSystem[size] = -1;
        wasOut[size] = false;
        added[size] = 0;
        return size++;
    }

    private void grow(int capacity) {
        a = Arrays.copyOf(a, capacity);
        b = Arrays.copyOf(b, capacity);
        previous = Arrays.copyOf(previous, capacity);
        inSystem = Arrays.copyOf(inSystem, capacity);
        wasOut = Arrays.copyOf(wasOut, capacity);
        added = Arrays.copyOf(added, capacity);
        index = Arrays.copyOf(index, capacity);
    }

    /** Takes the contacts of the system from an index on; from 0 on, those of the system before are in it no longer. */
    void enter(Bodies bodies, int from) {
        for (int p = 0; p < size && from == 0; p++) {
            wasOut[p] = inSystem[p] >= 0 ? !inSet[p] : wasOut[p];
            inSystem[p] = -1;
        }
        for (int k = from; k < system.size; k++) {
            int p = expect(system.a[k], system.b[k]);
            index[k] = p;
            inSystem[p] = k;
        }
        if (rows < size) {
            analyse(bodies);
        }
    }

    /** Finds the entries of the factor; all rows are to be computed. */
    private void analyse(Bodies bodies) {
        rows = size;
        order.find(bodies, a, b, rows);
        growRows(bodies);
        for (int i = 0; i < rows; i++) {
            rank[order.order[i]] = i;
        }
        findRows(bodies);
        findEntries();
    }

    private void growRows(Bodies bodies) {
        if (rank.length < rows) {
            int capacity = Math.max(2 * rows, 3 * bodies.capacity());
            inSet = new boolean[capacity];
            normalX = new double[capacity];
            normalY = new double[capacity];
            rank = new int[capacity];
            rowStart = new int[capacity + 1];
            parent = new int[capacity];
            seen = new int[capacity];
            path = new int[capacity];
            factorStart = new int[capacity + 1];
            columnStart = new int[capacity + 1];
            diagonal = new double[capacity];
            work = new double[capacity];
            stale = new boolean[capacity];
            bodyContact = new int[2 * capacity];
        }
        if (bodyStart.length < bodies.size() + 2) {
            bodyStart = new int[bodies.capacity() + 2];
        }
        Arrays.fill(stale, 0, rows, true);
    }

    private void findRows(Bodies bodies) {
        Arrays.fill(bodyStart, 0, bodies.size() + 2, 0);
        for (int k = 0; k < rows; k++) {
            bodyStart[a[k] + 2]++;
            if (b[k] >= 0) {
                bodyStart[b[k] + 2]++;
            }
        }
        for (int i = 2; i < bodies.size() + 2; i++) {
            bodyStart[i] += bodyStart[i - 1];
        }
        for (int k = 0; k < rows; k++) {
            bodyContact[bodyStart[a[k] + 1]++] = k;
            if (b[k] >= 0) {
                bodyContact[bodyStart[b[k] + 1]++] = k;
            }
        }
        int entries = 0;
        for (int i = 0; i < rows; i++) {
            rowStart[i] = entries;
            int k = order.order[i];
            entries = addRow(bodies, i, a[k], entries);
            if (b[k] >= 0) {
                entries = addRow(bodies, i, b[k], entries);
            }
        }
        rowStart[rows] = entries;
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
        Arrays.fill(columnStart, 0, rows + 1, 0);
        int entries = 0;
        for (int i = 0; i < rows; i++) {
            parent[i] = -1;
            seen[i] = i;
            factorStart[i] = entries;
            int top = rows;
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
            if (factorColumn.length < entries + rows - top) {
                factorColumn = Arrays.copyOf(factorColumn, 2 * factorColumn.length + USUAL * rank.length);
            }
            for (; top < rows; top++) {
                columnStart[path[top] + 1]++;
                factorColumn[entries++] = path[top];
            }
        }
        factorStart[rows] = entries;
        if (factorPlace.length < entries) {
            factorPlace = new int[factorColumn.length];
            columnRow = new int[factorColumn.length];
            value = new double[factorColumn.length];
        }
        for (int j = 0; j < rows; j++) {
            columnStart[j + 1] += columnStart[j];
            path[j] = columnStart[j];
        }
        for (int i = 0; i < rows; i++) {
            for (int at = factorStart[i]; at < factorStart[i + 1]; at++) {
                int place = path[factorColumn[at]]++;
                factorPlace[at] = place;
                columnRow[place] = i;
            }
        }
    }

    /** True if a contact of the system was in one before, of which the last has left it out of its set. */
    boolean wasOut(int k) {
        return wasOut[index[k]];
    }

    /** Adds a number to the diagonal of a contact of the system, instead of the one before. */
    void add(int k, double number) {
        int p = index[k];
        if (added[p] != number) {
            added[p] = number;
            change(p);
        }
    }

    /** Takes note that a contact has another row. */
    private void change(int p) {
        for (int i = rank[p]; i >= 0 && !stale[i]; i = parent[i]) {
            stale[i] = true;
        }
    }

    /** Computes the rows that have changed since the last time. */
    void factorize(Bodies bodies, boolean[] active) {
        for (int p = 0; p < rows; p++) {
            int k = inSystem[p];
            boolean enters = k >= 0 && active[k];
            if (enters != inSet[p] || enters && (system.normalX[k] != normalX[p] || system.normalY[k] != normalY[p])) {
                change(p);
                inSet[p] = enters;
                normalX[p] = enters ? system.normalX[k] : 0;
                normalY[p] = enters ? system.normalY[k] : 0;
            }
        }
        for (int i = 0; i < rows; i++) {
            if (stale[i]) {
                stale[i] = false;
                computeRow(bodies, i);
            }
        }
    }

    private void computeRow(Bodies bodies, int i) {
        int p = order.order[i];
        double pivot = 1;
        if (inSet[p]) {
            int k = inSystem[p];
            for (int at = rowStart[i]; at < rowStart[i + 1]; at++) {
                int other = order.order[rowColumn[at]];
                work[rowColumn[at]] = inSet[other] ? system.coupling(bodies, k, inSystem[other]) : 0;
            }
            pivot = system.coupling(bodies, k, k) * (1 + REGULAR) + added[p];
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
        for (int k = 0; k < system.size; k++) {
            work[rank[index[k]]] = side[k];
        }
        for (int j = 0; j < rows; j++) {
            double known = work[j];
            if (known != 0) {
                for (int at = columnStart[j]; at < columnStart[j + 1]; at++) {
                    work[columnRow[at]] -= value[at] * known;
                }
            }
        }
        for (int j = rows - 1; j >= 0; j--) {
            double sum = work[j] / diagonal[j];
            for (int at = columnStart[j]; at < columnStart[j + 1]; at++) {
                sum -= value[at] * work[columnRow[at]];
            }
            work[j] = sum;
        }
        for (int k = 0; k < system.size; k++) {
            side[k] = work[rank[index[k]]];
        }
        Arrays.fill(work, 0, rows, 0);
    }
}
