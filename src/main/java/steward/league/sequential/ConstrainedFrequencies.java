package steward.league.sequential;

import java.util.Arrays;

/**
 * Maximum-likelihood probabilities of scores under a hypothesis, given how often each score occurred. Source: M. Van
 * den Bergh, "Comments on normalized Elo", https://www.cantate.be/Fishtest, propositions 1.1 and 1.2.
 *
 * <p>With f<sub>i</sub> the frequency of the score a<sub>i</sub>, the sum of f<sub>i</sub> log p<sub>i</sub> is
 * greatest under the condition g(p) = 0 where, by Lagrange's multipliers,
 *
 * <pre>
 *   p[i] = f[i] / (1 + x phi[i])        with x such that the sum of p[i] phi[i] is 0
 *   mean s           g = m - s               phi[i] = a[i] - s
 *   t-statistic t    g = m - 1/2 - t d       phi[i] = a[i] - 1/2 - t d/2 (1 + ((a[i] - m)/d)^2)
 * </pre>
 *
 * m and d are mean and standard deviation under p; phi is the gradient of g, shifted so that its mean under p is g.
 * With a mean, x is found once. With t, phi depends on p, and both are found in turn, beginning with all scores equally
 * likely, until they agree: one to nine times where t is usual. No f may be 0.
 */
final class ConstrainedFrequencies {

    private static final int MOST_ROUNDS = 100;
    private static final int MOST_STEPS = 200;
    private static final double CLOSE = 1e-9;
    private static final double EVEN = 0.5;
    private static final double ROUNDING = 4e-15;

    private final double[] scores;
    private final double[] frequencies;
    private final double[] gradient;
    private final double[] found;

    /**
     * @param scores      ascending, the first below 1/2 and the last above it
     * @param frequencies all above 0, with the sum 1
     */
    ConstrainedFrequencies(double[] scores, double... frequencies) {
        this.scores = scores;
        this.frequencies = frequencies;
        gradient = new double[scores.length];
        found = new double[scores.length];
    }

    /** The most likely chances with this mean. */
    double[] ofMean(double mean) {
        for (int k = 0; k < scores.length; k++) {
            gradient[k] = scores[k] - mean;
        }
        tilt();
        return found.clone();
    }

    /** The most likely chances whose mean is so many standard deviations above 1/2. */
    double[] ofDeviations(double t) {
        Arrays.fill(found, 1.0 / found.length);
        double change = 1;
        for (int round = 0; round < MOST_ROUNDS && change > CLOSE; round++) {
            if (!setGradient(t)) {
                moveTo(t);
                setGradient(t);
            }
            change = tilt();
        }
        return found.clone();
    }

    /** Sets the gradient at the chances found so far. @return true if it has both signs, so that there is an x */
    private boolean setGradient(double t) {
        double mean = mean();
        double deviation = deviation(mean);
        boolean above = false;
        boolean below = false;
        for (int k = 0; k < scores.length; k++) {
            double distance = (scores[k] - mean) / deviation;
            gradient[k] = scores[k] - EVEN - t * deviation / 2 * (1 + distance * distance);
            above |= gradient[k] > 0;
            below |= gradient[k] < 0;
        }
        return above && below;
    }

    /** Mixes so much of the outermost score into the chances that they fulfil the condition: then there is an x. */
    private void moveTo(double t) {
        double[] from = found.clone();
        double low = 0;
        double high = 1;
        for (int step = 0; step < Double.SIZE; step++) {
            double share = (low + high) / 2;
            mix(from, share, t > 0);
            double mean = mean();
            if ((mean - EVEN) / deviation(mean) < t == t > 0) {
                low = share;
            } else {
                high = share;
            }
        }
        mix(from, low, t > 0);
    }

    private void mix(double[] from, double share, boolean up) {
        for (int k = 0; k < found.length; k++) {
            found[k] = (1 - share) * from[k] + (k == (up ? found.length - 1 : 0) ? share : 0);
        }
    }

    private double mean() {
        double sum = 0;
        for (int k = 0; k < scores.length; k++) {
            sum += found[k] * scores[k];
        }
        return sum;
    }

    private double deviation(double mean) {
        double sum = 0;
        for (int k = 0; k < scores.length; k++) {
            sum += found[k] * (scores[k] - mean) * (scores[k] - mean);
        }
        return Math.sqrt(sum);
    }

    /**
     * Finds x by Newton's method within a bracket and sets the chances. The sum falls with x, from above 0 to below 0
     * between the x at which a chance would be infinite. Beside such an x steps are short, and tell no end.
     *
     * @return the greatest change of a chance
     */
    private double tilt() {
        double highest = 0;
        double lowest = 0;
        for (double each : gradient) {
            highest = Math.max(highest, each);
            lowest = Math.min(lowest, each);
        }
        double low = -1 / highest;
        double high = -1 / lowest;
        double x = 0;
        for (int step = 0; step < MOST_STEPS; step++) {
            double sum = 0;
            double size = 0;
            double slope = 0;
            for (int k = 0; k < gradient.length; k++) {
                double term = gradient[k] / (1 + x * gradient[k]);
                sum += frequencies[k] * term;
                size += frequencies[k] * Math.abs(term);
                slope += frequencies[k] * term * term;
            }
            if (Math.abs(sum) < ROUNDING * size) {
                break;
            }
            if (sum > 0) {
                low = x;
            } else {
                high = x;
            }
            double next = x + sum / slope;
            x = next > low && next < high ? next : (low + high) / 2;
            if (x == low || x == high) {
                break;
            }
        }
        double change = 0;
        for (int k = 0; k < gradient.length; k++) {
            double chance = frequencies[k] / (1 + x * gradient[k]);
            change = Math.max(change, Math.abs(chance - found[k]));
            found[k] = chance;
        }
        return change;
    }
}
