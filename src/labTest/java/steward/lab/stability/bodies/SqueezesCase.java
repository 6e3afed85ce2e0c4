package steward.lab.stability.bodies;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.TurnLog;
import steward.physics.Wall;

/**
 * Stability case of many impacts in a turn that are not rest. A light body is between a wall and a heavy one, or a body
 * flies into a corner again and again.
 */
public final class SqueezesCase extends StabilityCase {

    private static final long SEED = 55;
    private static final MathContext DIGITS = new MathContext(50);
    private static final double MOST_ERROR = 1e-9;
    /** A squeeze with more impacts than these, or that leaves less than this speed of 50, collapses and is left out. */
    private static final int MOST_IMPACTS = 4_000;
    private static final double LEAST_SPEED = 1e-3;
    /** Mass, restitution, places, turns. */
    private static final double[][] NAMED = {{30, 0.99, 10, 60, 1}, {3, 0.95, 10, 60, 1}, {1e6, 0.99999, 15, 100, 20}};

    public SqueezesCase() {
        super("squeezes", "a light body between a wall and a heavy one that comes at 50, with mass ratios 3 to 1e6 "
            + "and e = 0.9 to 0.99999, where the impacts do not collapse. A body that flies into a corner, with e ="
            + " 0.99 and 0.999999. Impacts, velocities and energy are those of the sequence in 50 digits, to 1e-9. "
            + "On event rungs of ours");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        double worst = 0;
        int wrong = 0;
        int most = 0;
        int played = 0;
        SplitMix64 random = new SplitMix64(SEED);
        int count = size.pick(10, 100, 1_000);
        for (int n = 0; n < NAMED.length + count; n++) {
            double[] squeeze = n < NAMED.length ? NAMED[n] : new double[] {StrictMath.pow(10, 0.5 + 3 * random
                .nextDouble()), 1 - StrictMath.pow(10, -1 - 3 * random.nextDouble()), 10 + 5 * random.nextDouble(),
                50 + 40 * random.nextDouble(), 1 + random.nextInt(3)};
            Truth truth = new Truth(squeeze);
            if (truth.collapses()) {
                continue;
            }
            played++;
            Bodies bodies = new Bodies(2);
            Falls.add(bodies, squeeze[2], 0, 1, squeeze[1]);
            Falls.add(bodies, squeeze[3], 0, squeeze[0], squeeze[1]);
            bodies.setVelocity(1, -50, 0);
            Advance advance = rung.advance(Falls.SOFT, new HalfPlane(0, 0, 1, 0, 1));
            TurnLog log = new TurnLog();
            int impacts = 0;
            for (int turn = 0; turn < squeeze[4]; turn++) {
                log.clear();
                advance.turn(bodies, log);
                impacts += log.impacts();
            }
            most = Math.max(most, impacts);
            wrong += impacts == truth.impacts ? 0 : 1;
            worst = Math.max(worst, truth.error(bodies));
        }
        for (double restitution : new double[] {0.99, 0.999999}) {
            worst = Math.max(worst, corner(rung, restitution));
        }
        return Finding.of(rung.isOurs(), worst <= MOST_ERROR && wrong == 0 && played > count / 2, String.format(
            Locale.ROOT, "%d squeezes of up to %d impacts: %d with other counts, off by %.1e", played, most, wrong,
            worst));
    }

    /** Each hit of the corner is one of both walls: the energy is that of the start times e^2 for each. */
    private static double corner(Rung rung, double restitution) {
        Bodies bodies = new Bodies(1);
        Falls.add(bodies, 500, restitution == 0.99 ? 500.006 : 500, 1, restitution);
        bodies.setVelocity(0, 3000, 3000);
        TurnLog log = new TurnLog();
        rung.advance(Falls.SOFT, Wall.box(1000, 1000, 1)).turn(bodies, log);
        double energy = (bodies.vx[0] * bodies.vx[0] + bodies.vy[0] * bodies.vy[0]) / 2;
        double right = 9e6 * StrictMath.pow(restitution, log.impacts());
        return log.impacts() == 6 ? Math.abs(energy / right - 1) : Double.POSITIVE_INFINITY;
    }

    /** The sequence of impacts: the gaps are those to the wall and between the two. */
    private static final class Truth {

        private int impacts;
        private BigDecimal light = BigDecimal.ZERO;
        private BigDecimal heavy = BigDecimal.valueOf(-50);
        private final BigDecimal mass;

        Truth(double[] squeeze) {
            mass = new BigDecimal(squeeze[0]);
            BigDecimal back = BigDecimal.ONE.add(new BigDecimal(squeeze[1]));
            BigDecimal wall = new BigDecimal(squeeze[2]).subtract(BigDecimal.TEN);
            BigDecimal between = new BigDecimal(squeeze[3]).subtract(new BigDecimal(squeeze[2]))
                .subtract(BigDecimal.valueOf(20));
            BigDecimal left = BigDecimal.valueOf(squeeze[4]);
            for (;;) {
                BigDecimal closing = light.subtract(heavy);
                BigDecimal meet = closing.signum() > 0 ? between.divide(closing, DIGITS) : left.add(BigDecimal.ONE);
                BigDecimal hit = light.signum() < 0 ? wall.divide(light.negate(), DIGITS) : left.add(BigDecimal.ONE);
                BigDecimal next = meet.min(hit);
                if (next.compareTo(left) > 0 || impacts == MOST_IMPACTS) {
                    return;
                }
                left = left.subtract(next, DIGITS);
                wall = wall.add(light.multiply(next), DIGITS);
                between = between.subtract(closing.multiply(next), DIGITS);
                impacts++;
                if (hit.compareTo(meet) < 0) {
                    wall = BigDecimal.ZERO;
                    light = light.subtract(light.multiply(back), DIGITS);
                } else {
                    between = BigDecimal.ZERO;
                    BigDecimal impulse = closing.multiply(back).multiply(mass).divide(mass.add(BigDecimal.ONE), DIGITS);
                    light = light.subtract(impulse, DIGITS);
                    heavy = heavy.add(impulse.divide(mass, DIGITS), DIGITS);
                }
            }
        }

        /** True if the heavy body has lost nearly all of its speed: then the law lets it rest. */
        boolean collapses() {
            return impacts == MOST_IMPACTS || heavy.abs().doubleValue() < LEAST_SPEED;
        }

        /** The larger error of a velocity, relative to the faster one, and of the energy. */
        double error(Bodies bodies) {
            double scale = Math.max(light.abs().doubleValue(), heavy.abs().doubleValue());
            double off = Math.max(Math.abs(bodies.vx[0] - light.doubleValue()),
                Math.abs(bodies.vx[1] - heavy.doubleValue())) / scale;
            double right = light.multiply(light).add(heavy.multiply(heavy).multiply(mass)).doubleValue();
            double energy = bodies.vx[0] * bodies.vx[0] + bodies.mass[1] * bodies.vx[1] * bodies.vx[1];
            return Math.max(off, Math.abs(energy / right - 1));
        }
    }
}
