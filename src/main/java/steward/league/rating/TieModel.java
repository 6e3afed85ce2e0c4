package steward.league.rating;

/**
 * One game of two by the model of Davidson (R. R. Davidson, "On extending the Bradley-Terry model to accommodate ties
 * in paired comparison experiments", Journal of the American Statistical Association 65, 1970): with d the difference
 * of ratings in natural units and n the weight of ties, win : tie : loss = exp(d/2) : n : exp(-d/2). Without ties it is
 * the model of Bradley and Terry. In d and log n it is an exponential family whose statistics are the points (1, 1/2,
 * 0) and whether it was a tie; their means and covariances are the derivatives of the logarithm of the likelihood.
 *
 * <p>Holds the numbers of the game that was computed last.
 */
final class TieModel {

    /** Expected points. */
    double points;
    /** The probability of a tie. */
    double tie;
    /** Variance of the points. */
    double pointsVariance;
    /** Covariance of points and tie. */
    double covariance;
    /** Variance of the tie. */
    double tieVariance;

    /**
     * Computes.
     *
     * @param difference of the ratings, in natural units
     * @param ties       weight of ties, at least 0
     */
    void compute(double difference, double ties) {
        double up = StrictMath.exp(difference / 2);
        double down = 1 / up;
        double all = up + ties + down;
        double win = up / all;
        tie = ties / all;
        points = win + tie / 2;
        // Of x in {1, 1/2, 0} about its mean, from the chances to win, tie and lose.
        double loss = down / all;
        pointsVariance = win * loss + tie * (win + loss) / 4;
        covariance = tie * (loss - win) / 2;
        tieVariance = tie * (1 - tie);
    }
}
