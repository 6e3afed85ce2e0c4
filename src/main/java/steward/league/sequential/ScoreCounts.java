package steward.league.sequential;

import java.util.Map;
import java.util.TreeMap;

/**
 * Scores of one bot against another, one for each seed that both have played from all seats: (1 + d) / 2, with d the
 * difference of their points averaged over the games, so that 1/2 is even. For two players it is 0, 1/4, 1/2, 3/4 or 1,
 * and the counts are a pentanomial.
 */
public final class ScoreCounts {

    /** What a score counts that has not been seen: without it one-sided beginnings would be certain (as fishtest). */
    private static final double UNSEEN = 1e-3;

    /** Observations. */
    private static final double MIXED = 2;

    private final int games;
    private final Map<Double, Long> counts = new TreeMap<>();
    private long observations;

    /**
     * @param games by seed: from how many seats each plays
     */
    public ScoreCounts(int games) {
        this.games = games;
        if (games == 2) {
            for (int k = 0; k <= 4; k++) {
                counts.put(k / 4.0, 0L);
            }
        } else {
            counts.put(0.0, 0L);
            counts.put(0.5, 0L);
            counts.put(1.0, 0L);
        }
    }

    /** Adds a score. */
    public void add(double score) {
        add(score, 1);
    }

    /** Adds a score that came so often. */
    public void add(double score, long count) {
        if (!(score >= 0 && score <= 1)) {
            throw new IllegalArgumentException("score " + score + ", expected 0 to 1");
        }
        counts.merge(score, count, Long::sum);
        observations += count;
    }

    /** How many there are. */
    public long observations() {
        return observations;
    }

    /** Games of an observation. */
    public int games() {
        return games;
    }

    /** How often each score came, from the lowest; also those that have not come. */
    public Map<Double, Long> counts() {
        return new TreeMap<>(counts);
    }

    private static double weight(long count) {
        return count == 0 ? UNSEEN : count;
    }

    /** All weights together. */
    double total() {
        double total = 0;
        for (long count : counts.values()) {
            total += weight(count);
        }
        return total;
    }

    /** The mean score. */
    public double mean() {
        double sum = 0;
        for (Map.Entry<Double, Long> each : counts.entrySet()) {
            sum += each.getKey() * weight(each.getValue());
        }
        return sum / total();
    }

    /**
     * The variance of an observation. Two observations of even games that do not go together are mixed in: a few that
     * are alike are not certain.
     */
    public double variance() {
        double mean = mean();
        double sum = 0;
        for (Map.Entry<Double, Long> each : counts.entrySet()) {
            double distance = each.getKey() - mean;
            sum += distance * distance * weight(each.getValue());
        }
        return (sum + MIXED / (4.0 * games)) / (total() + MIXED);
    }
}
