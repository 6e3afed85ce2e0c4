package steward.league.rating;

/** Symmetric positive definite systems. */
final class Cholesky {

    private final double[][] lower;

    /** Finds the lower triangle L with L Lᵀ the matrix. */
    Cholesky(double[][] matrix) {
        int size = matrix.length;
        lower = new double[size][size];
        for (int i = 0; i < size; i++) {
            double[] row = lower[i];
            for (int j = 0; j <= i; j++) {
                double sum = matrix[i][j];
                double[] other = lower[j];
                for (int k = 0; k < j; k++) {
                    sum -= row[k] * other[k];
                }
                row[j] = i == j ? Math.sqrt(sum) : sum / other[j];
            }
        }
    }

    /** The solution for a right side. */
    double[] solve(double... right) {
        int size = right.length;
        double[] x = right.clone();
        for (int i = 0; i < size; i++) {
            double sum = x[i];
            for (int k = 0; k < i; k++) {
                sum -= lower[i][k] * x[k];
            }
            x[i] = sum / lower[i][i];
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

    /** The inverse of the matrix. */
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
