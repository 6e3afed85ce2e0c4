package steward.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/** The bound that {@link CompensatedCircles} states, against 60 digits. */
@Execution(ExecutionMode.CONCURRENT)
class CompensatedCirclesTest {

    /** Derived in the class: 4.9 units, whatever cancels. */
    private static final double BOUND = 5;

    private final SplitMix64 random = new SplitMix64(44);
    private double worst;
    private int hits;

    /** How near a touch or a graze is, relative: down to 1e-13, which is within the 2^-46 that the class names. */
    private double near() {
        return StrictMath.pow(10, -13 * random.nextDouble());
    }

    /**
     * One flight: the point (dx, dy) towards a circle of radius s around the origin, at an offset from its centre of a
     * share of s, from a gap away.
     */
    private void check(double share, double gap, int lengths, int speeds) {
        double angle = 2 * Math.PI * random.nextDouble();
        double ux = StrictMath.cos(angle);
        double uy = StrictMath.sin(angle);
        double along = share < 1 ? Math.sqrt(1 - share * share) + gap : gap;
        double length = Math.scalb(1 + random.nextDouble(), lengths);
        double speed = Math.scalb(1 + random.nextDouble(), speeds);
        double dx = length * (-along * ux - share * uy);
        double dy = length * (-along * uy + share * ux);
        double vx = speed * ux;
        double vy = speed * uy;
        BigDecimal[] crossings = Exact.crossings(dx, dy, vx, vy, Exact.of(length));
        double found = new CompensatedCircles().until(dx, dy, vx, vy, length);
        String what = "share " + share + ", gap " + gap + ", 2^" + lengths + ", 2^" + speeds;
        assertEquals(crossings != null, found < Double.POSITIVE_INFINITY, what);
        if (crossings != null) {
            double error = Exact.error(found, crossings[0]) / Math.ulp(crossings[0].doubleValue());
            assertTrue(error <= BOUND, what + ": " + error + " ulp");
            worst = Math.max(worst, error);
            hits++;
        }
    }

    @Test
    @Tag("sized")
    void isWithinFiveUlpOverAllExponents() {
        int cases = TestSize.of(1000, 6000);
        for (int n = 0; n < cases; n++) {
            check(1.1 * random.nextDouble(), 0.001 + 10 * random.nextDouble(), random.nextInt(-150, 150),
                random.nextInt(-150, 150));
        }
        assertTrue(hits > 0.8 * cases && worst > 0.5, hits + " hits, worst " + worst);
    }

    @Test
    @Tag("sized")
    void isWithinFiveUlpWhenItGrazesAndWhenItIsNear() {
        int cases = TestSize.of(1000, 6000);
        for (int n = 0; n < cases; n++) {
            double off = near();
            check(n % 3 == 0 ? 1 + off : 1 - off, 0.5 + random.nextDouble(), 0, 0);
            check(0.9 * random.nextDouble(), near(), 0, 0);
        }
        assertTrue(hits > 1.5 * cases && worst > 0.5, hits + " hits, worst " + worst);
    }
}
