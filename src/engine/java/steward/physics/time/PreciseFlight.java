package steward.physics.time;

import steward.numerics.ErrorFree;

/**
 * Coordinate in free flight between two double-double times, rounded once. Besides the returned doubles, results are in
 * {@link #elapsedLow} and {@link #placeLow}. One instance serves one thread.
 */
public final class PreciseFlight {

    /** The low part of the last result of {@link #elapsed}. */
    public double elapsedLow;
    /** The low part of the last result of {@link #coordinate}. */
    public double placeLow;

    /** The time from one double-double to another; call before {@link #coordinate}. */
    public double elapsed(double since, double sinceLow, double now, double nowLow) {
        double time = now - since;
        double rest = ErrorFree.sumError(now, -since, time);
        double sum = time + nowLow;
        rest += ErrorFree.sumError(time, nowLow, sum);
        time = sum + rest;
        rest = ErrorFree.fastSumError(sum, rest, time);
        sum = time - sinceLow;
        rest += ErrorFree.sumError(time, -sinceLow, sum);
        time = sum + rest;
        elapsedLow = ErrorFree.fastSumError(sum, rest, time);
        return time;
    }

    /** A coordinate after the last result of {@link #elapsed}, which is {@code time}. */
    public double coordinate(double from, double v, double time) {
        double product = v * time;
        double lowProduct = v * elapsedLow;
        double path = product + lowProduct;
        double rest = ErrorFree.fastSumError(product, lowProduct, path) + ErrorFree.productError(v, time, product);
        double whole = path + rest;
        double sum = whole + from;
        rest = ErrorFree.fastSumError(path, rest, whole) + ErrorFree.sumError(whole, from, sum);
        double place = sum + rest;
        placeLow = ErrorFree.fastSumError(sum, rest, place);
        return place;
    }
}
