package steward.league.rating;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Covariance matrix A^-1 B A^-1 (sandwich) of all ratings: variances of all differences of n ratings with n^3
 * operations. Computed one by one, each difference would take a sum over all pairings, n^4 in all.
 */
final class Covariance {

    /** (a - b)^4 is at most 8 (a^4 + b^4). */
    private static final double FOURTH = 8;

    private final RatingFit fit;
    private final double[][] matrix;
    /** By bot: the strata in which it is. */
    private final List<List<Integer>> own = new ArrayList<>();
    /** By bot: sum of the squares of the other strata's parts in the variance of its rating, by degrees of freedom. */
    private final double[] others;

    Covariance(RatingFit fit) {
        this.fit = fit;
        double[][] inverse = fit.inverse();
        ClusterSpread spread = fit.spread();
        double[][] middle = new double[inverse.length][inverse.length];
        spread.addTo(middle);
        matrix = product(inverse, product(middle, inverse));
        others = new double[fit.bots()];
        for (int bot = 0; bot < others.length; bot++) {
            own.add(new ArrayList<>());
        }
        for (int q = 0; q < fit.strata().size(); q++) {
            int[] bots = fit.strata().get(q).bots;
            for (int bot = 0; bot < others.length; bot++) {
                if (Arrays.binarySearch(bots, bot) >= 0) {
                    own.get(bot).add(q);
                } else {
                    others[bot] += byFreedom(q, inverse[bot]);
                }
            }
        }
    }

    private double byFreedom(int q, double... along) {
        ClusterSpread spread = fit.spread();
        double part = spread.isAny(q) ? spread.along(q, along) : 0;
        return part == 0 ? 0 : part * part / spread.freedom(q);
    }

    private static double[][] product(double[][] left, double[]... right) {
        double[][] product = new double[left.length][left.length];
        for (int i = 0; i < left.length; i++) {
            for (int k = 0; k < left.length; k++) {
                double factor = left[i][k];
                double[] row = product[i];
                double[] other = right[k];
                for (int j = 0; factor != 0 && j < row.length; j++) {
                    row[j] += factor * other[j];
                }
            }
        }
        return product;
    }

    /** The variance of the difference of two ratings of one component, in natural units. */
    double variance(int one, int other) {
        return matrix[one][one] + matrix[other][other] - 2 * matrix[one][other];
    }

    /** A number that the degrees of freedom of that variance are not below, and hardly above. */
    double leastFreedom(int one, int other) {
        double[] along = fit.along(one, other);
        double sum = FOURTH * (others[one] + others[other]);
        for (int bot : new int[] {one, other}) {
            for (int q : own.get(bot)) {
                sum += byFreedom(q, along);
            }
        }
        return variance(one, other) * variance(one, other) / sum;
    }
}
