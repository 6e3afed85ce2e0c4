package steward.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.numerics.DoubleDouble;
import steward.numerics.SplitMix64;
import steward.physics.HalfPlane;
import steward.physics.Wall;

/**
 * The exact arithmetic at half-planes against the definition in decimals, where gap and closing speed cancel by
 * anything from nothing to all of their digits: signs are right, times good to ten digits more than a double has.
 */
@Execution(ExecutionMode.CONCURRENT)
class ExactHalfPlaneTest {

    private static final BigDecimal BOUND = Exact.of(0x1p-62);

    /**
     * <pre>
     *        o ---->        nearly along the wall, nearly at it
     *     ____________
     * </pre>
     */
    @Test
    void flightsAlongTheWallAndGapsNextToNothingKeepEveryDigit() {
        SplitMix64 random = new SplitMix64(1);
        DoubleDouble time = new DoubleDouble();
        int hits = 0;
        int touches = 0;
        int misses = 0;
        for (int n = 0; n < 6000; n++) {
            double angle = n % 4 == 0 ? Math.PI / 2 * random.nextInt(4) : 2 * Math.PI * random.nextDouble();
            HalfPlane plane = new HalfPlane(1e4 * random.nextDouble(), 1e4 * random.nextDouble(), Math.cos(angle),
                Math.sin(angle), 1);
            double closing = any(random);
            double gap = any(random);
            double along = 1e4 * random.nextDouble();
            double radius = 500 * random.nextDouble();
            double x = plane.x() + (radius + gap) * plane.insideX() - along * plane.insideY();
            double y = plane.y() + (radius + gap) * plane.insideY() + along * plane.insideX();
            double vx = -800 * (closing * plane.insideX() + plane.insideY());
            double vy = -800 * (closing * plane.insideY() - plane.insideX());
            BigDecimal exactGap = Exact.of(x).subtract(Exact.of(plane.x())).multiply(Exact.of(plane.insideX()))
                .add(Exact.of(y).subtract(Exact.of(plane.y())).multiply(Exact.of(plane.insideY())))
                .subtract(Exact.of(radius));
            BigDecimal exactClosing = Exact.dot(vx, vy, plane.insideX(), plane.insideY()).negate();
            boolean hit = new ExactWalls(new Wall[] {plane}).exactTime(0, x, y, vx, vy, radius, time);
            String what = "n " + n + ", gap " + exactGap.doubleValue() + ", closing " + exactClosing.doubleValue();
            assertEquals(exactClosing.signum() > 0, hit, what);
            if (!hit) {
                misses++;
            } else if (exactGap.signum() <= 0) {
                assertEquals(0, time.high(), what);
                touches++;
            } else {
                BigDecimal exact = exactGap.divide(exactClosing, Exact.DIGITS);
                BigDecimal error = Exact.of(time.high()).add(Exact.of(time.low())).subtract(exact).abs();
                assertTrue(error.compareTo(exact.multiply(BOUND)) <= 0, what);
                hits++;
            }
        }
        assertTrue(hits > 1000 && touches > 1000 && misses > 1000, hits + ", " + touches + ", " + misses);
    }

    /** Of any size from 1 down to 1e-18, more often than not positive. */
    private static double any(SplitMix64 random) {
        double size = StrictMath.pow(10, -18 * random.nextDouble());
        return random.nextInt(3) == 0 ? -size : size;
    }
}
