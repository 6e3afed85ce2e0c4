package steward.league.tune;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import steward.numerics.SplitMix64;

/**
 * Simultaneous perturbation stochastic approximation, which tunes all parameters at once. Source: J. C. Spall,
 * "Implementation of the simultaneous perturbation algorithm for stochastic optimization", IEEE Transactions on
 * Aerospace and Electronic Systems 34, 1998. Each step moves every parameter up or down at random, plays that against
 * the opposite, and goes on along the difference of the two scores. The gains get smaller as Spall recommends: a/(A +
 * k)^0.602 and c/k^0.101, with A a tenth of all steps.
 */
public final class Spsa {

    private static final double GAIN_POWER = 0.602;
    private static final double MOVE_POWER = 0.101;
    /** How far a parameter is moved at first, as a share of its range. */
    private static final double MOVE = 0.15;
    /** Of its range: how far a parameter goes in the first step, if the scores differ by {@link #USUAL}. */
    private static final double FIRST_STEP = 0.08;
    private static final double USUAL = 0.25;
    /** The result is the mean over the last part of all steps. */
    private static final int LAST_PART = 4;

    private final TunedCommand command;
    private final int steps;
    private final double[] places;
    private final List<double[]> path = new ArrayList<>();
    private final long seed;

    /** @param seed of the lots */
    public Spsa(TunedCommand command, int steps, long seed) {
        this.command = command;
        this.steps = steps;
        this.seed = seed;
        places = command.start();
        path.add(places.clone());
    }

    /** Returns how many steps have been made. */
    public int step() {
        return path.size() - 1;
    }

    /** True if all steps have been made. */
    public boolean isOver() {
        return step() >= steps;
    }

    /** The places to be tried in the next step: +1 for the one side, -1 for the other. */
    public double[] trial(int sign) {
        double[] trial = places.clone();
        double[] lots = lots();
        for (int k = 0; k < trial.length; k++) {
            trial[k] = inside(trial[k] + sign * lots[k] * move(k));
        }
        return trial;
    }

    private double[] lots() {
        SplitMix64 random = new SplitMix64(seed + step());
        random.nextLong();
        return IntStream.range(0, places.length).mapToDouble(k -> random.nextLong() < 0 ? -1 : 1).toArray();
    }

    private double move(int parameter) {
        return Math.max(command.parameters().get(parameter).step(), MOVE / StrictMath.pow(step() + 1, MOVE_POWER));
    }

    private static double inside(double place) {
        return Math.max(0, Math.min(1, place));
    }

    /** Goes on by the scores, 0..1, of the two trials. */
    public void go(double plus, double minus) {
        double[] lots = lots();
        double stability = steps / 10.0;
        double gain = StrictMath.pow((stability + 1) / (stability + step() + 1), GAIN_POWER);
        for (int k = 0; k < places.length; k++) {
            double slope = (plus - minus) / (USUAL * lots[k]);
            places[k] = inside(places[k] + FIRST_STEP * gain * slope * MOVE / move(k));
        }
        path.add(places.clone());
    }

    /** All places so far, the start first. */
    public List<double[]> path() {
        return path.stream().map(double[]::clone).toList();
    }

    /** The mean over the last quarter of the path. */
    public double[] result() {
        int from = path.size() - Math.max(1, path.size() / LAST_PART);
        double[] mean = new double[places.length];
        for (double[] each : path.subList(from, path.size())) {
            for (int k = 0; k < mean.length; k++) {
                mean[k] += each[k] / (path.size() - from);
            }
        }
        return mean;
    }

    /** Returns how far the path was from its mean over the last quarter: the root of the mean square, by parameter. */
    public double[] spread() {
        int from = path.size() - Math.max(1, path.size() / LAST_PART);
        double[] mean = result();
        double[] spread = new double[places.length];
        for (int k = 0; k < mean.length; k++) {
            double sum = 0;
            for (double[] each : path.subList(from, path.size())) {
                sum += (each[k] - mean[k]) * (each[k] - mean[k]);
            }
            spread[k] = Math.sqrt(sum / (path.size() - from));
        }
        return spread;
    }
}
