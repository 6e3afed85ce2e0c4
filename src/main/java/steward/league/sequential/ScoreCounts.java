package steward.league.sequential;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * Counts of the scores of one bot against another, one score for each seed that both have played from all seats. A
 * score is (1 + d) / 2, with d the difference of their points averaged over the games, so that 1/2 is even. For two
 * players it is 0, 1/4, 1/2, 3/4 or 1, and the counts are a pentanomial.
 */
public final class ScoreCounts {

    /** Observations. */
    private static final double MIXED = 2;

    private final int games;
    /** Ascending. */
    private double[] scores;
    /** How often each came. */
    private long[] counts;
    private long observations;

    /** @param games by seed: from how many seats each plays */
    public ScoreCounts(int games) {
        this.games = games;
        scores = games == 2 ? new double[] {0, 0.25, 0.5, 0.75, 1} : new double[] {0, 0.5, 1};
        counts = new long[scores.length];
    }

    public void add(double score) {
        add(score, 1);
    }

    /** Adds a score that came so often. */
    public void add(double score, long count) {
        if (!(score >= 0 && score <= 1)) {
            throw new IllegalArgumentException("score " + score + ", expected 0 to 1");
        }
        int place = Arrays.binarySearch(scores, score + 0.0);              // -0 is 0
        if (place < 0) {
            place = -place - 1;
            scores = inserted(scores, place);
            scores[place] = score;
            long[] old = counts;
            counts = new long[scores.length];
            System.arraycopy(old, 0, counts, 0, place);
            System.arraycopy(old, place, counts, place + 1, old.length - place);
        }
        counts[place] += count;
        observations += count;
    }

    private static double[] inserted(double[] values, int place) {
        double[] more = new double[values.length + 1];
        System.arraycopy(values, 0, more, 0, place);
        System.arraycopy(values, place, more, place + 1, values.length - place);
        return more;
    }

    /** The score of each cell, ascending. */
    double[] values() {
        return scores;
    }

    /** Observations in a cell, {@link Gsprt#EMPTY} in one that is empty. */
    double count(int cell) {
        return Math.max(Gsprt.EMPTY, counts[cell]);
    }

    /** The share of each cell, as {@link #count} counts. */
    double[] frequencies() {
        double sum = 0;
        for (int k = 0; k < counts.length; k++) {
            sum += count(k);
        }
        double all = sum;
        return IntStream.range(0, counts.length).mapToDouble(k -> count(k) / all).toArray();
    }

    public long observations() {
        return observations;
    }

    /** Games of an observation. */
    public int games() {
        return games;
    }

    /** Returns how often each score came, from the lowest; also those that have not come. */
    public Map<Double, Long> counts() {
        Map<Double, Long> all = new TreeMap<>();
        for (int k = 0; k < scores.length; k++) {
            all.put(scores[k], counts[k]);
        }
        return all;
    }

    /** The mean score; NaN where there is none. */
    public double mean() {
        double sum = 0;
        for (int k = 0; k < scores.length; k++) {
            sum += scores[k] * counts[k];
        }
        return sum / observations;
    }

    /** The variance of an observation, see {@link #mixed}. */
    public double variance() {
        double mean = mean();
        double sum = 0;
        for (int k = 0; k < scores.length; k++) {
            double distance = scores[k] - mean;
            sum += distance * distance * counts[k];
        }
        return mixed(sum / observations, 1);
    }

    /**
     * Mixes two observations of even games that do not go together into a variance: a few that are alike are not
     * certain.
     *
     * @param span from the lowest value of an observation to the highest
     */
    double mixed(double variance, double span) {
        return (observations * variance + MIXED * span * span / (4.0 * games)) / (observations + MIXED);
    }
}
