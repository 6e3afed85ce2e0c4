package steward.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.DoubleDouble;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.event.Scenes;

/**
 * Decisions and times of the exact arithmetic against the definition in decimals: every decision is right, every time
 * is within 0.51 units in the last place, every lower bound of the search is one.
 */
@Execution(ExecutionMode.CONCURRENT)
class ExactCirclesTest {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final MathContext DIGITS = new MathContext(60);

    private final ExactPairs pairs = new ExactPairs(ImpactLaw.PHYSICS);
    private final DoubleDouble time = new DoubleDouble();
    private double worst;
    private int hits;
    private int misses;
    private int wrongInDouble;
    private int wrongCompensated;

    /** d, v and s of a pair, exactly; the touch by the definition, null for none. */
    private static BigDecimal touch(Bodies bodies) {
        BigDecimal dx = minus(bodies.x[0], bodies.x[1]);
        BigDecimal dy = minus(bodies.y[0], bodies.y[1]);
        BigDecimal vx = minus(bodies.vx[0], bodies.vx[1]);
        BigDecimal vy = minus(bodies.vy[0], bodies.vy[1]);
        BigDecimal s = Exact.of(bodies.radius[0]).add(Exact.of(bodies.radius[1]));
        BigDecimal approach = dx.multiply(vx).add(dy.multiply(vy)).negate();
        if (approach.signum() <= 0) {
            return null;
        }
        BigDecimal excess = Exact.square(dx).add(Exact.square(dy)).subtract(Exact.square(s));
        if (excess.signum() <= 0) {
            return BigDecimal.ZERO;
        }
        BigDecimal speedSquared = Exact.square(vx).add(Exact.square(vy));
        BigDecimal room = Exact.square(approach).subtract(speedSquared.multiply(excess));
        return room.signum() <= 0 ? null : excess.divide(approach.add(room.sqrt(DIGITS)), DIGITS);
    }

    private static BigDecimal minus(double a, double b) {
        return Exact.of(a).subtract(Exact.of(b));
    }

    private static Bodies pair(double x, double y, double vx, double vy, double ra, double rb) {
        Bodies bodies = Scenes.bodies(new double[][] {{x, y, vx, vy, 1, ra}, {0, 0, 0, 0, 1, rb}});
        return bodies;
    }

    private void check(Bodies bodies, String what) {
        BigDecimal exact = touch(bodies);
        boolean hit = pairs.exactTime(bodies, 0, 1, time);
        double bound = pairs.until(bodies, 0, 1, bodies.radius[0], bodies.radius[1]);
        if (exact == null || exact.compareTo(Exact.of(Double.MAX_VALUE)) > 0) {
            assertEquals(false, hit, () -> what + ": found " + time.high());
            assertTrue(bound == NEVER || bound > 2, () -> what + ": bound " + bound);
            misses++;
        } else {
            assertTrue(hit, () -> what + ": not found " + exact.doubleValue());
            boolean below = bound == NEVER
                ? exact.compareTo(BigDecimal.ONE) > 0 : Exact.of(bound).compareTo(exact) <= 0;
            assertTrue(bound >= 0 && below, () -> what + ": bound " + bound + " of " + exact);
            double ulp = Math.ulp(exact.doubleValue());
            double error = Exact.of(time.high()).subtract(exact).abs().divide(Exact.of(ulp), DIGITS).doubleValue();
            worst = Math.max(worst, error);
            assertTrue(error <= 0.51, () -> what + ": " + error + " ulp of " + exact);
            hits++;
        }
        count(bodies, exact != null);
    }

    private void count(Bodies bodies, boolean hit) {
        double dx = bodies.x[0] - bodies.x[1];
        double dy = bodies.y[0] - bodies.y[1];
        double vx = bodies.vx[0] - bodies.vx[1];
        double vy = bodies.vy[0] - bodies.vy[1];
        double s = bodies.radius[0] + bodies.radius[1];
        wrongInDouble += hit == CircleTime.stable(dx, dy, vx, vy, s) < NEVER ? 0 : 1;
        wrongCompensated += hit == new CompensatedCircles().until(dx, dy, vx, vy, s) < NEVER ? 0 : 1;
    }

    /**
     * <pre>
     *     o-------->            passes the other at a distance of R (1 +- 10^-k)
     *               O  R
     * </pre>
     */
    @Test
    @Tag("sized")
    void grazingPassesAreDecidedRightly() {
        for (int k = 1; k <= 16; k++) {
            for (long seed = 1; seed <= TestSize.of(100, 400); seed++) {
                SplitMix64 random = new SplitMix64(1000 * k + seed);
                double radius = Math.pow(10, 12 * random.nextDouble() - 6);
                double far = radius * (2 + Math.pow(10, 6 * random.nextDouble()));
                double angle = 2 * Math.PI * random.nextDouble();
                double off = 2 * radius * (1 + Math.pow(10, -k) * (random.nextInt(2) * 2 - 1));
                double speed = Math.pow(10, 8 * random.nextDouble() - 4);
                double cos = Math.cos(angle);
                double sin = Math.sin(angle);
                check(pair(-far * cos - off * sin, -far * sin + off * cos, speed * cos, speed * sin, radius, radius),
                    "k " + k + " seed " + seed);
            }
        }
        assertTrue(hits > TestSize.of(500, 2000) && misses > TestSize.of(500, 2000),
            hits + " hits, " + misses + " misses");
        assertTrue(wrongInDouble > TestSize.of(25, 100), "so that it matters: wrong in double " + wrongInDouble);
        assertTrue(wrongCompensated < wrongInDouble / 10, wrongCompensated + " of " + wrongInDouble);
    }

    /** Along an axis the tangent is exact in doubles: D = 0, a miss; one unit in the last place nearer is a hit. */
    @Test
    @Tag("sized")
    void aTangentPathIsAMissAndOneUlpNearerIsAHit() {
        for (long seed = 1; seed <= TestSize.of(500, 2000); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double radius = Math.rint(1e6 * random.nextDouble() + 1) / 1024;
            double far = -3 * radius - Math.rint(1e9 * random.nextDouble());
            double speed = 1 + 1e4 * random.nextDouble();
            double off = 2 * radius;
            boolean across = random.nextInt(2) == 0;
            for (double y : new double[] {off, Math.nextUp(off), Math.nextDown(off)}) {
                Bodies bodies = across ? pair(y, far, 0, speed, radius, radius)
                    : pair(far, y, speed, 0, radius, radius);
                assertEquals(y < off, pairs.exactTime(bodies, 0, 1, time), "seed " + seed + " off " + y);
                check(bodies, "seed " + seed + " off " + y);
            }
        }
    }

    /** Pythagorean flights: (3, 4)/5 and (5, 12)/13 make tangents exact in oblique directions too. */
    @Test
    @Tag("sized")
    void obliqueTangentsAreMisses() {
        for (int k = 1; k <= TestSize.of(800, 3000); k++) {
            double[] t = k % 2 == 0 ? new double[] {3, 4, 5} : new double[] {5, 12, 13};
            double far = 1000 + k;
            double r = k % 17 + 1;
            Bodies bodies = pair(-far * t[0] - 2 * r * t[1], -far * t[1] + 2 * r * t[0], t[0], t[1],
                r * t[2], r * t[2]);
            assertEquals(false, pairs.exactTime(bodies, 0, 1, time), "k " + k);
            check(bodies, "k " + k);
            bodies.radius[0] = Math.nextUp(bodies.radius[0]);
            assertEquals(true, pairs.exactTime(bodies, 0, 1, time), "k " + k + ", one ulp larger");
            check(bodies, "k " + k);
        }
    }

    /** Both far from the origin, so that differences of coordinates are what counts; ratios of 1e12. */
    @Test
    @Tag("sized")
    void translationsAndRatiosDoNotMatter() {
        for (long seed = 1; seed <= TestSize.of(800, 3000); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double small = Math.pow(10, -12 * random.nextDouble());
            double shift = random.nextInt(2) * 1e9 * random.nextDouble();
            Bodies bodies = new Bodies(2);
            double angle = 2 * Math.PI * random.nextDouble();
            double aim = (1 + small) * (random.nextInt(3) == 0 ? 1 - 1e-15 : random.nextDouble());
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            bodies.add(shift + 1e3 * cos - aim * sin, shift + 1e3 * sin + aim * cos, small, 1);
            bodies.add(shift, shift, 1, 1);
            double speed = Math.pow(10, 12 * random.nextDouble());
            bodies.setVelocity(0, -speed * cos, -speed * sin);
            bodies.setVelocity(1, random.nextDouble(), random.nextDouble());
            check(bodies, "seed " + seed);
        }
        assertTrue(hits > TestSize.of(250, 1000), hits + " hits");
    }

    /** Gap 1e-12 of the radius closing at 1e-9 of it; separated by 1e7 radii. */
    @Test
    @Tag("sized")
    void tinyGapsAndGreatDistancesKeepEveryDigit() {
        for (long seed = 1; seed <= TestSize.of(800, 3000); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double angle = 2 * Math.PI * random.nextDouble();
            double apart = seed % 2 == 0 ? 2 * (1 + 1e-12 * random.nextDouble()) : 1e7 * random.nextDouble();
            double speed = seed % 2 == 0 ? 1e-9 : 1e7;
            double lean = angle + (seed % 2 == 0 ? 2 * random.nextDouble() - 1 : 1e-7 * random.nextDouble());
            check(pair(apart * Math.cos(angle), apart * Math.sin(angle), -speed * Math.cos(lean),
                -speed * Math.sin(lean), 1, 1), "seed " + seed);
        }
        assertTrue(hits > TestSize.of(250, 1000), hits + " hits");
    }

    /** Numbers of all exponents, from the least subnormal to the largest double. */
    @Test
    @Tag("sized")
    void allExponentsAreDecidedRightly() {
        int cases = TestSize.of(800, 6000);
        for (long seed = 1; seed <= cases; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            boolean wild = seed % 40 == 0;
            int length = random.nextInt(-1000, 1000);
            int speed = random.nextInt(-1000, 1000);
            int spread = wild ? 1000 : 30;
            Bodies bodies = new Bodies(2);
            bodies.add(any(random, length, spread), any(random, length, spread),
                Math.abs(any(random, length, spread)), 1);
            bodies.add(random.nextInt(2) * any(random, length, spread), any(random, length, spread),
                Math.abs(any(random, length, spread)), 1);
            bodies.setVelocity(0, -bodies.x[0] / Math.abs(bodies.x[0]) * Math.abs(any(random, speed, spread)),
                any(random, speed, spread));
            bodies.setVelocity(1, random.nextInt(2) * any(random, speed, spread), 0);
            check(bodies, "seed " + seed);
        }
        assertTrue(hits > cases / 12 && misses > cases / 12, hits + " hits, " + misses + " misses");
    }

    private static double any(SplitMix64 random, int exponent, int spread) {
        double value = Math.scalb(1 + random.nextDouble(), Math.max(-1070, Math.min(1021,
            exponent + random.nextInt(-spread, spread))));
        return random.nextInt(2) == 0 ? value : -value;
    }

    /** Where the quick way in double-double answers at all, it is right; whoever asks for less gets more answers. */
    @Test
    @Tag("sized")
    void theQuickWayIsGoodToTenDigitsMoreThanADoubleOrSilent() {
        int cases = TestSize.of(2_000, 12_000);
        int fine = quickAnswers(FastCircles.FINE, cases);
        int coarse = quickAnswers(FastCircles.COARSE, cases);
        assertTrue(fine > cases / 3 && coarse > fine + cases / 12, fine + " fine, " + coarse + " coarse");
    }

    private int quickAnswers(double grade, int cases) {
        SplitMix64 random = new SplitMix64(36);
        int answers = 0;
        int nones = 0;
        for (int n = 0; n < cases; n++) {
            double off = StrictMath.pow(10, -17 * random.nextDouble());
            double along = StrictMath.pow(10, -17 * random.nextDouble());
            double across = n % 2 == 0 ? n % 5 == 0 ? 1 + off : 1 - off : random.nextDouble();
            double angle = 2 * Math.PI * random.nextDouble();
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            double back = -Math.sqrt(Math.max(0, 1 - across * across))
                - (n % 3 == 0 ? along : Math.pow(10, 12 * random.nextDouble()) * random.nextDouble());
            double radius = 390 + 1e-3 * random.nextDouble();
            double x = (radius + 410) * (back * cos - across * sin);
            double y = (radius + 410) * (back * sin + across * cos);
            Bodies bodies = pair(x, y, 900 * cos, 900 * sin, radius, 410);
            int found = quickTouch(bodies, grade, time);
            if (found == FastCircles.UNDECIDED) {
                continue;
            }
            BigDecimal exact = touch(bodies);
            Supplier<String> what = () -> "off " + off + ", gap " + along + ", angle " + angle;
            assertEquals(exact != null, found == FastCircles.IMPACT, what);
            answers++;
            if (exact != null) {
                BigDecimal told = Exact.of(time.high()).add(Exact.of(time.low()));
                assertTrue(told.subtract(exact).abs().compareTo(exact.multiply(Exact.of(0x1p-62))) <= 0, what);
            } else {
                nones++;
            }
        }
        assertTrue(nones > cases / 24, nones + " that miss");
        return answers;
    }

    /** Pythagorean tangents of many digits, and circles larger by 2^-107 of their size: D is 0, or next to nothing. */
    @Test
    @Tag("sized")
    void theQuickWayIsSilentWhereDoubleDoublesCannotTell() {
        SplitMix64 random = new SplitMix64(37);
        for (int n = 0; n < TestSize.of(800, 3000); n++) {
            double[] t = n % 2 == 0 ? new double[] {3, 4, 5} : new double[] {5, 12, 13};
            double far = Math.rint(1e14 * (1 + random.nextDouble()));
            double r = Math.rint(1e14 * random.nextDouble());
            double speed = Math.rint(1e14 * (1 + random.nextDouble()));
            Bodies bodies = pair(-far * t[0] - r * t[1], -far * t[1] + r * t[0], speed * t[0], speed * t[1],
                r * t[2], 1);
            bodies.radius[1] = 0;
            int found = quickTouch(bodies, FastCircles.COARSE, time);
            assertTrue(found != FastCircles.IMPACT, "n " + n);
            bodies.radius[1] = Math.scalb(r * t[2], -107);
            found = quickTouch(bodies, FastCircles.COARSE, time);
            assertTrue(found != FastCircles.NONE, "n " + n + ", a little larger");
            assertTrue(pairs.exactTime(bodies, 0, 1, time), "n " + n + ", a little larger, exactly");
        }
    }

    private static int quickTouch(Bodies bodies, double grade, DoubleDouble time) {
        return FastCircles.firstTouch(bodies.x[0], bodies.x[1], bodies.y[0], bodies.y[1], bodies.vx[0], bodies.vx[1],
            bodies.vy[0], bodies.vy[1], bodies.radius[0], bodies.radius[1], false, grade, time);
    }
}
