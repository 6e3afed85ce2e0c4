package steward.lab.stability.bodies;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.stream.DoubleStream;
import steward.lab.trial.Finding;
import steward.lab.trial.OracleTurns;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/** Stability case of columns of discs that fall on a floor one after the other. */
public final class ColumnsCase extends StabilityCase {

    private static final long SEED = 57;
    private static final int MOST_IMPACTS = 1_000;
    private static final double MOST_OFF = 1e-9;
    /** One column in so many has no restitution: it lies when the highest has fallen. */
    private static final int WITHOUT = 7;

    public ColumnsCase() {
        super("falling columns", "columns of 2 to 5 discs, equal or not, dropped from gaps of 5 to 65 turns' "
            + "acceleration, with e = 0 or 0.5 to 0.95, gravity 0.5 to 5.5. Their sequence of impacts in 50 digits "
            + "collapses once. They lie still no later than that collapse and 4 turns, no earlier than after half "
            + "of it. Of every 10th turn, 19 of 20 are the oracle's to 1e-9 of the speeds. On event rungs of ours");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        SplitMix64 random = new SplitMix64(SEED);
        int columns = size.pick(10, 40, 500);
        int played = 0;
        OracleTurns truth = new OracleTurns(MOST_OFF);
        int moving = 0;
        double late = Double.NEGATIVE_INFINITY;
        double early = Double.POSITIVE_INFINITY;
        for (int n = 0; n < columns; n++) {
            int count = n == 0 ? 2 : 2 + random.nextInt(4);
            double a = n == 0 ? 2 : 0.5 + 5 * random.nextDouble();
            double e = n == 0 ? 0.8 : n % WITHOUT == 0 ? 0 : 0.5 + 0.45 * random.nextDouble();
            double[] gaps = new double[count];
            double[] masses = new double[count];
            for (int k = 0; k < count; k++) {
                gaps[k] = n == 0 ? 190 - 110 * k : (5 + 60 * random.nextDouble()) * a;
                masses[k] = n == 0 || random.nextInt(2) == 0 ? 1 : 0.3 + 3 * random.nextDouble();
            }
            double collapse = e == 0 ? Math.sqrt(2 * DoubleStream.of(gaps).sum() / a) : collapse(gaps, masses, e, a);
            if (Double.isNaN(collapse)) {
                continue;
            }
            played++;
            Bodies bodies = new Bodies(count);
            double y = 10;
            for (int k = 0; k < count; k++) {
                y -= gaps[k] + 20;
                Falls.add(bodies, 0, y, masses[k], e);
            }
            int still = new Falls(bodies, rung, n % 2 == 1, Falls.SOFT, a, Falls.FLOOR)
                .comparing(truth, 10).playUntilStill((int) collapse + 100);
            moving += still < 0 ? 1 : 0;
            late = Math.max(late, still - collapse);
            early = Math.min(early, still / collapse);
        }
        boolean met = played > 0 && moving == 0 && late <= 4 && early >= 0.5 && truth.areTrue();
        return Finding.of(rung.isOurs(), met, String.format(Locale.ROOT, "%d columns, %d never still; at most %.2f "
            + "turns after the collapse, at least after %.2f of it; %s", played, moving, late, early,
            truth.text()));
    }

    /** Returns when the impacts end, or NaN if others come after a first collapse. */
    private static double collapse(double[] gaps, double[] masses, double e, double a) {
        Sequence sequence = new Sequence(gaps, masses, e, a);
        for (int impacts = 0; impacts < MOST_IMPACTS; impacts++) {
            sequence.next();
            if (sequence.height() < 1e-12 * a) {
                return sequence.now.doubleValue();
            }
        }
        return Double.NaN;
    }

    /** Parabolas and impacts of points above each other; the heights are those of the gaps. */
    private static final class Sequence {

        private static final MathContext DIGITS = new MathContext(50);
        private static final BigDecimal TWO = BigDecimal.valueOf(2);

        private final BigDecimal gravity;
        private final BigDecimal back;
        private final BigDecimal[] height;
        private final BigDecimal[] speed;
        private final BigDecimal[] mass;
        private BigDecimal now = BigDecimal.ZERO;

        Sequence(double[] gaps, double[] masses, double e, double a) {
            gravity = new BigDecimal(a);
            back = BigDecimal.ONE.add(new BigDecimal(e));
            height = new BigDecimal[gaps.length];
            speed = new BigDecimal[gaps.length];
            mass = new BigDecimal[gaps.length];
            BigDecimal sum = BigDecimal.ZERO;
            for (int k = 0; k < gaps.length; k++) {
                sum = sum.add(new BigDecimal(gaps[k]));
                height[k] = sum;
                speed[k] = BigDecimal.ZERO;
                mass[k] = new BigDecimal(masses[k]);
            }
        }

        /** The height to which the highest would rise, and more. */
        double height() {
            double most = 0;
            for (int k = 0; k < height.length; k++) {
                double v = speed[k].doubleValue();
                most = Math.max(most, height[k].doubleValue() + v * v / (2 * gravity.doubleValue()));
            }
            return most;
        }

        /** Flies to the next impact, and lets it react. */
        void next() {
            BigDecimal until = speed[0].add(speed[0].multiply(speed[0])
                .add(TWO.multiply(gravity).multiply(height[0].max(BigDecimal.ZERO))).sqrt(DIGITS))
                .divide(gravity, DIGITS);
            int lower = -1;
            for (int k = 0; k + 1 < height.length; k++) {
                BigDecimal closing = speed[k].subtract(speed[k + 1]);
                if (closing.signum() > 0) {
                    BigDecimal time = height[k + 1].subtract(height[k]).max(BigDecimal.ZERO).divide(closing, DIGITS);
                    lower = time.compareTo(until) < 0 ? k : lower;
                    until = until.min(time);
                }
            }
            for (int k = 0; k < height.length; k++) {
                BigDecimal change = gravity.multiply(until);
                height[k] = height[k].add(speed[k].subtract(change.divide(TWO, DIGITS)).multiply(until), DIGITS);
                speed[k] = speed[k].subtract(change, DIGITS);
            }
            now = now.add(until, DIGITS);
            if (lower < 0) {
                height[0] = BigDecimal.ZERO;
                speed[0] = speed[0].subtract(speed[0].multiply(back), DIGITS);
                return;
            }
            height[lower + 1] = height[lower];
            BigDecimal impulse = speed[lower].subtract(speed[lower + 1]).multiply(back).multiply(mass[lower])
                .multiply(mass[lower + 1]).divide(mass[lower].add(mass[lower + 1]), DIGITS);
            speed[lower] = speed[lower].subtract(impulse.divide(mass[lower], DIGITS), DIGITS);
            speed[lower + 1] = speed[lower + 1].add(impulse.divide(mass[lower + 1], DIGITS), DIGITS);
        }
    }
}
