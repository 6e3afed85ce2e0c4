package steward.report;

import steward.text.TextFormat;

/** Mean and standard deviation of a value; mean and sum of squares around it are carried on (Welford 1962). */
public final class MeanValue {

    private long count;
    private double mean;
    private double squares;

    public void add(double value) {
        count++;
        double before = value - mean;
        mean += before / count;
        squares += before * (value - mean);
    }

    public long count() {
        return count;
    }

    /** NaN without values. */
    public double mean() {
        return count == 0 ? Double.NaN : mean;
    }

    /** NaN of less than two values. */
    public double deviation() {
        return count < 2 ? Double.NaN : Math.sqrt(squares / (count - 1));
    }

    /** Both with two decimals, or a dash. */
    public String text() {
        return count == 0 ? "-" : TextFormat.fixed(mean, 2) + " ± " + TextFormat.fixed(deviation(), 2);
    }
}
