package steward.league.rating;

/** Solver of linear systems with a symmetric positive definite matrix, by Cholesky's decomposition. */
final class Cholesky {

    private final double[][] lower;

    /** Finds the lower triangle L with L Lᵀ the matrix. */
    Cholesky(double[][] matrix) {
        int size = matrix.length;
        lower = new double[size][size];
        for (int i = 0; i < size; i++) {
            double[] row = lower[i];
            for (int j = 0; j <= i; j++) {
                double[] other = lower[j];
                double sum = matrix[i][j] - product(row, other, j);
                row[j] = i == j ? Math.sqrt(sum) : sum / other[j];
            }
        }
    }

    /** Sum of the products of the first numbers; four sums at once, which do not wait for one another. */
    private static double product(double[] one, double[] other, int count) {
        double first = 0;
        double second = 0;
        double third = 0;
        double fourth = 0;
        int k = 0;
        for (; k + 3 < count; k += 4) {
            first += one[k] * other[k];
            second += one[k + 1] * other[k + 1];
            third += one[k + 2] * other[k + 2];
            fourth += one[k + 3] * other[k + 3];
        }
        for (; k < count; k++) {
            first += one[k] * other[k];
        }
        return first + second + (third + fourth);
    }

    /** The solution for a right side. */
    double[] solve(double... right) {
        int size = right.length;
        double[] x = right.clone();
        for (int i = 0; i < size; i++) {
            x[i] = (x[i] - product(lower[i], x, i)) / lower[i][i];
        }
        for (int i = size - 1; i >= 0; i--) {
            double solved = x[i] / lower[i][i];
            x[i] = solved;
            double[] row = lower[i];
            for (int k = 0; k < i; k++) {
                x[k] -= row[k] * solved;
            }
        }
        return x;
    }

    double[][] inverse() {
        int size = lower.length;
        double[][] inverse = new double[size][];
        for (int i = 0; i < size; i++) {
            double[] unit = new double[size];
            unit[i] = 1;
            inverse[i] = solve(unit);
        }
        return inverse;
    }
}
