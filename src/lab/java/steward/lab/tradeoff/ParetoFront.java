package steward.lab.tradeoff;

/**
 * The Pareto front of cost and error: a point on it can be improved in one of them only at the expense of the other.
 */
final class ParetoFront {

    /**
     * Returns which points are on the front: those that no other point beats in one respect while being at least as
     * good in the other. Equal points are on it together; NaN never is.
     */
    static boolean[] of(double[] cost, double[] error) {
        boolean[] front = new boolean[cost.length];
        for (int i = 0; i < front.length; i++) {
            front[i] = cost[i] == cost[i] && error[i] == error[i];
            for (int j = 0; j < front.length && front[i]; j++) {
                front[i] = !(cost[j] <= cost[i] && error[j] <= error[i] && (cost[j] < cost[i] || error[j] < error[i]));
            }
        }
        return front;
    }
}
