package steward.machines.check;

/**
 * Fisher's exact test of whether one worker's games have a mark too often. Of {@code all} games {@code marked} have the
 * mark; {@code own} of them are the worker's, {@code hits} with the mark. If games were dealt out blindly, the number
 * of hits would have the hypergeometric distribution (R. A. Fisher, "The Logic of Inductive Inference", 1935). Groups
 * of games that are not alike are added one by one: their numbers of hits are independent, so the sum's distribution is
 * the convolution.
 */
final class DrawnWithout {

    /** With more different sums than this the normal distribution is close enough. */
    private static final int MOST = 4000;

    private double[] chances = {1};
    /** The sum that the first chance belongs to. */
    private long lowest;
    private long hits;
    private double mean;
    private double variance;
    private long span;

    /** Adds a group of games. */
    void add(int all, int marked, int own, int ownHits) {
        int low = Math.max(0, own - (all - marked));
        int high = Math.min(own, marked);
        double share = (double) marked / all;
        hits += ownHits;
        mean += own * share;
        variance += all < 2 ? 0 : own * share * (1 - share) * (all - own) / (all - 1.0);
        lowest += low;
        span += high - low;
        if (span > MOST) {
            chances = null;
        }
        if (chances != null && high > low) {
            chances = convolved(chances, hypergeometric(all, marked, own, low, high));
        }
    }

    /** By the ratio of neighbours, from the largest on, so that nothing overflows. */
    private static double[] hypergeometric(int all, int marked, int own, int low, int high) {
        double[] chances = new double[high - low + 1];
        int mode = (int) Math.max(low, Math.min(high, (own + 1.0) * (marked + 1.0) / (all + 2.0)));
        chances[mode - low] = 1;
        for (int k = mode; k < high; k++) {
            chances[k + 1 - low] = chances[k - low] * (marked - k) * (own - k)
                / ((k + 1.0) * (all - marked - own + k + 1.0));
        }
        for (int k = mode; k > low; k--) {
            chances[k - 1 - low] = chances[k - low] * k * (all - marked - own + k)
                / ((marked - k + 1.0) * (own - k + 1.0));
        }
        double sum = 0;
        for (double chance : chances) {
            sum += chance;
        }
        for (int k = 0; k < chances.length; k++) {
            chances[k] /= sum;
        }
        return chances;
    }

    private static double[] convolved(double[] one, double... other) {
        double[] both = new double[one.length + other.length - 1];
        for (int i = 0; i < one.length; i++) {
            for (int j = 0; j < other.length; j++) {
                both[i + j] += one[i] * other[j];
            }
        }
        return both;
    }

    /** Twice the chance of so many hits or more, or of so many or fewer, whichever is less; at most 1. */
    double chance() {
        if (chances == null) {
            double z = variance > 0 ? Math.max(0, Math.abs(hits - mean) - 0.5) / StrictMath.sqrt(variance) : 0;
            return Math.min(1, 2 * upperTail(z));
        }
        double below = 0;
        double above = 0;
        for (int k = 0; k < chances.length; k++) {
            below += lowest + k <= hits ? chances[k] : 0;
            above += lowest + k >= hits ? chances[k] : 0;
        }
        return Math.min(1, 2 * Math.min(below, above));
    }

    /** A bound from above for the standard normal distribution: density / z, at most a half. */
    private static double upperTail(double z) {
        return z <= 0 ? 0.5 : Math.min(0.5, StrictMath.exp(-z * z / 2) / (z * StrictMath.sqrt(2 * Math.PI)));
    }

    /** Returns how many were to be expected. */
    double mean() {
        return mean;
    }
}
