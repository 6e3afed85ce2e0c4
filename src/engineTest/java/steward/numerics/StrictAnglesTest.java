package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/**
 * Bit for bit the values of StrictMath: at random arguments of every kind, on and beside every number at which the
 * algorithm changes its way. One million pairs, or what the system property {@code steward.angles} says.
 */
@Execution(ExecutionMode.CONCURRENT)
class StrictAnglesTest {

    private static final long COUNT = Long.getLong("steward.angles", 500_000);
    private static final long SEED = Long.getLong("steward.seed", 3);
    private static final double[] RATIOS = {0.4375, 0.6875, 1.1875, 2.4375, 0x1p-28, 0x1p58, 0x1p-60, 0x1p61};

    private final SplitMix64 random = new SplitMix64(SEED);

    @Test
    @Tag("slow")
    void everyBitIsThatOfStrictMath(TestReporter report) {
        report.publishEntry("seed " + SEED + ", " + COUNT + " arguments");
        for (long k = 0; k < COUNT; k++) {
            double y = argument();
            double x = random.nextInt(3) == 0 ? y / near(RATIOS[random.nextInt(RATIOS.length)]) : argument();
            checkArcTangent(y, x);
        }
    }

    private double argument() {
        return switch (random.nextInt(5)) {
            case 0 -> random.nextInt(-20000, 20000);
            case 1 -> random.nextInt(-30, 30);
            case 2 -> Double.longBitsToDouble(random.nextLong());
            case 3 -> (random.nextDouble() - 0.5) * Math.scalb(1.0, random.nextInt(-80, 80));
            default -> (random.nextDouble() - 0.5) * 100;
        };
    }

    private double near(double value) {
        return value * (1 + random.nextInt(-5, 5) * Math.scalb(1.0, -random.nextInt(10, 52)));
    }

    @Test
    void specialValuesToo() {
        double[] values = {0, -0.0, 1, -1, Double.MIN_VALUE, Double.MAX_VALUE, Double.NaN, Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY, Math.PI, Double.MIN_NORMAL};
        for (double y : values) {
            for (double x : values) {
                checkArcTangent(y, x);
            }
        }
    }

    private static void checkArcTangent(double y, double x) {
        assertEquals(StrictMath.atan2(y, x), StrictAngles.atan2(y, x), () -> "atan2(" + y + ", " + x + ")");
    }
}
