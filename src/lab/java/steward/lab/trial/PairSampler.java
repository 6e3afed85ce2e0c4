package steward.lab.trial;

import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/** Sampler of random pairs of bodies that meet or nearly meet, for cases and tests. */
public final class PairSampler {

    private PairSampler() { }

    /**
     * A pair that passes at a given distance.
     *
     * @param touch  the sum of the radii
     * @param share  the distance at which their centres pass, as a share of the touch: below 1 they meet
     * @param gap    their distance along the path, beyond the touch
     * @param time   approximate time of impact
     * @param baseX  position of b
     */
    public static Bodies passing(SplitMix64 random, double touch, double share, double gap, double time, double baseX,
                          double baseY) {
        double ux = 2 * random.nextDouble() - 1;
        double uy = 2 * random.nextDouble() - 1;
        double length = Math.sqrt(ux * ux + uy * uy);
        ux /= length;
        uy /= length;
        double radius = touch * (0.1 + 0.8 * random.nextDouble());
        double along = gap + touch;
        double speed = along / time;
        Bodies bodies = new Bodies(2);
        bodies.add(baseX - along * ux - share * touch * uy, baseY - along * uy + share * touch * ux, radius, 1);
        bodies.add(baseX, baseY, touch - radius, 1);
        double drift = random.nextInt(2) == 0 ? 0 : speed * (random.nextDouble() - 0.5);
        bodies.setVelocity(0, speed * ux + drift, speed * uy - drift);
        bodies.setVelocity(1, drift, -drift);
        return bodies;
    }

    /** A random number between 1 and 10 times a power of 10. */
    public static double around(SplitMix64 random, int exponent) {
        return (1 + 9 * random.nextDouble()) * StrictMath.pow(10, exponent);
    }
}
