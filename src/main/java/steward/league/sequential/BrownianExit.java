package steward.league.sequential;

import steward.league.rating.Normal;

/**
 * Distribution of a Brownian motion with drift that ends at two barriers: its place after a time. The path begins at 0
 * and has unit variance per unit of time.
 *
 * <p>By the method of images (D. R. Cox and H. D. Miller, "The Theory of Stochastic Processes", 1965, chapter 5) the
 * time at which the path reaches the upper barrier b before the lower one a has, with w = b - a, the density
 *
 * <pre>sum over all whole k of c / sqrt(2 pi t^3) exp(m b - m^2 t/2 - c^2/(2 t)),  c = b + 2 k w, m the drift;</pre>
 *
 * each term is that of an inverse Gaussian distribution, whose integral is known. The place x at the time t has the
 * density exp(m x - m^2 t/2) times the sum of f(x - 2 k w) - f(x - 2 b + 2 k w), with f the density of the normal
 * distribution with variance t.
 *
 * @param lower below 0
 * @param upper above 0
 */
record BrownianExit(double lower, double upper) {

    private static final double SMALL = 1e-17;
    /** Standard deviations beyond which a normal tail is 0. */
    private static final double FAR = 10;

    /** Probability to reach the upper barrier by a time, and not the lower one before. */
    double above(double drift, double time) {
        return reached(upper, upper - lower, drift, time);
    }

    /** Probability to reach the lower barrier by a time, and not the upper one before. */
    double below(double drift, double time) {
        return reached(-lower, upper - lower, -drift, time);
    }

    private static double reached(double barrier, double width, double drift, double time) {
        double sum = 0;
        double most = Math.abs(drift) * time + FAR * Math.sqrt(time);
        for (int k = 0; ; k++) {
            double near = term(barrier + 2 * k * width, barrier, drift, time);
            double far = term(2 * (k + 1) * width - barrier, barrier, drift, time);
            sum += near - far;
            if (near < SMALL || 2 * k * width > most) {
                return Math.max(0, Math.min(1, sum));
            }
        }
    }

    private static double term(double image, double barrier, double drift, double time) {
        double steep = Math.abs(drift);
        double root = Math.sqrt(time);
        return Normal.scaledBelow(drift * barrier - steep * image, (steep * time - image) / root)
            + Normal.scaledBelow(drift * barrier + steep * image, -(steep * time + image) / root);
    }

    /**
     * Probability of an outcome that is worse than to be at a place at a time: to have reached the lower barrier, or to
     * be between the barriers and below the place.
     */
    double worse(double drift, double time, double place) {
        double width = upper - lower;
        int most = 1 + (int) ((Math.abs(drift) * time + FAR * Math.sqrt(time) + width) / (2 * width));
        double sum = below(drift, time);
        for (int k = -most; k <= most; k++) {
            sum += within(2 * k * width, drift, time, place) - within(2 * upper - 2 * k * width, drift, time, place);
        }
        return Math.max(0, Math.min(1, sum));
    }

    /** The part of an image between the lower barrier and a place. */
    private double within(double image, double drift, double time, double place) {
        double root = Math.sqrt(time);
        double low = (lower - image - drift * time) / root;
        double high = (place - image - drift * time) / root;
        double weight = drift * image;
        return low > 0 ? Normal.scaledBelow(weight, -low) - Normal.scaledBelow(weight, -high)
            : Normal.scaledBelow(weight, high) - Normal.scaledBelow(weight, low);
    }
}
