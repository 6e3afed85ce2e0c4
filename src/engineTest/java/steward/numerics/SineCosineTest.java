package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.Allocated;
import steward.match.TestSize;

/**
 * Sine and cosine are the nearest doubles, by the quick value and by the series alike, and the quick value is as near
 * as its derivation says: judged by {@link SineCosineOracle}. 150 thousand angles, or what the system property
 * {@code steward.angles} says; ten millions take some minutes.
 */
@Execution(ExecutionMode.CONCURRENT)
class SineCosineTest {

    private static final long COUNT = Long.getLong("steward.angles", 150_000);
    private static final long SEED = Long.getLong("steward.seed", 4);
    /** The bound derived in {@link SineCosine}. */
    private static final double BOUND = 0.813 * SineCosine.ERROR;
    private static final double[] ENDS = {0x1p10, 0x1p-27, 0x1p-8, 0x1p20, 0x1p52, 0x1p53, 0x1p64};

    private final SplitMix64 random = new SplitMix64(SEED);
    private final SineCosine angles = new SineCosine();
    private final SineCosine bySeries = new SineCosine(Double.POSITIVE_INFINITY);
    private final SineCosineOracle oracle = new SineCosineOracle();
    private double greatestError;

    @Test
    @Tag("sized")
    void everyResultIsTheNearestDouble(TestReporter report) {
        assertNearest(TestSize.isWhole() ? COUNT : Long.getLong("steward.angles", 15_000), report);
    }

    private void assertNearest(long count, TestReporter report) {
        long left = 0;
        for (long k = 0; k < count; k++) {
            double angle = angle();
            angles.sineHead = Double.NaN;
            check(angle);
            left += Double.isNaN(angles.sineHead) ? 0 : 1;
        }
        report.publishEntry("seed " + SEED + ", " + count + " angles; error of the quick value at most "
            + greatestError / SineCosine.ERROR + " of ERROR; " + left + " left to the series");
    }

    private double angle() {
        double angle = switch (random.nextInt(10)) {
            case 0, 1, 2 -> random.nextDouble() * 2 * Math.PI;
            case 3 -> (random.nextDouble() - 0.5) * 200;
            case 4 -> StrictMath.atan2(random.nextInt(-16000, 16000), random.nextInt(-9000, 9000))
                + random.nextInt(-160, 160) * (Math.PI / 10);
            case 5 -> near((random.nextInt(-400, 400) + 0.5) * (Math.PI / 128));        // farthest from the table's
            case 6 -> near(random.nextInt(-100_000, 100_000) * (Math.PI / 4));
            case 7 -> near(ENDS[random.nextInt(ENDS.length)]);
            case 8 -> Numbers.any(random, -30, 1023);
            default -> Double.longBitsToDouble(random.nextLong());
        };
        return Double.isFinite(angle) && angle != 0 ? angle : 1;
    }

    private double near(double value) {
        return value * (1 + random.nextInt(-5, 5) * Math.scalb(1.0, -random.nextInt(10, 52)));
    }

    private void check(double angle) {
        oracle.turn(angle);
        double sine = oracle.sin();
        double cosine = oracle.cos();
        angles.turn(angle);
        assertEquals(sine, angles.sin(), () -> "sin " + Double.toHexString(angle));
        assertEquals(cosine, angles.cos(), () -> "cos " + Double.toHexString(angle));
        bySeries.turn(angle);
        assertEquals(sine, bySeries.sin(), () -> "sin by series " + Double.toHexString(angle));
        assertEquals(cosine, bySeries.cos(), () -> "cos by series " + Double.toHexString(angle));
        double error = Math.max(oracle.distanceFromSine(bySeries.sineHead, bySeries.sineRest),
            oracle.distanceFromCosine(bySeries.cosineHead, bySeries.cosineRest));
        assertTrue(error < BOUND, () -> error / SineCosine.ERROR + " of ERROR at " + Double.toHexString(angle));
        greatestError = Math.max(greatestError, error);
    }

    /** Where sine or cosine is next to 0 and takes many digits of pi: every quarter turn of all magnitudes. */
    @Test
    void besideQuarterTurnsOfAnySize() {
        for (int exponent = 0; exponent < 1023; exponent++) {
            double angle = Math.rint(Numbers.any(random, exponent, exponent) * (2 / Math.PI)) * (Math.PI / 2);
            for (double beside : new double[] {angle, Math.nextUp(angle), Math.nextDown(angle), -angle}) {
                check(beside == 0 ? 1 : beside);
            }
        }
    }

    /**
     * The double nearest to a multiple of pi/2, 2^-60.9 from it, and the runners-up: found by continued fractions of
     * 2^e 2/pi; the first is in J.-M. Muller, "Elementary Functions".
     */
    @Test
    void nearestToQuarterTurnsOfAllDoubles() {
        double[][] known = {{6381956970095103.0, 797}, {3205513981387887.0, -46}, {7763785107565477.0, -29},
            {5916243447979695.0, 79}, {8444920710073313.0, 939}, {5850965514341686.0, 525}};
        for (double[] pair : known) {
            double angle = Math.scalb(pair[0], (int) pair[1]);
            check(angle);
            check(-angle);
            double nearest = Math.min(Math.abs(angles.sin()), Math.abs(angles.cos()));
            assertTrue(nearest < 0x1p-58 && nearest > 0x1p-61, () -> "at " + angle + ": " + nearest);
        }
    }

    @Test
    void powersOfTwoAndTheirNeighbours() {
        for (int exponent = -1074; exponent < 1024; exponent++) {
            double power = Math.scalb(1.0, exponent);
            check(power);
            check(-power);
            check(Math.nextUp(power));
            check(power == Double.MIN_VALUE ? power : Math.nextDown(power));
        }
        check(Double.MAX_VALUE);
        check(-Double.MAX_VALUE);
    }

    @Test
    void zerosKeepTheirSignAndWhatIsNotFiniteHasNone() {
        for (SineCosine either : new SineCosine[] {angles, bySeries}) {
            for (double zero : new double[] {0.0, -0.0}) {
                either.turn(zero);
                assertEquals(zero, either.sin());
                assertEquals(1.0, either.cos());
            }
            for (double none : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
                either.turn(none);
                assertEquals(Double.NaN, either.sin());
                assertEquals(Double.NaN, either.cos());
            }
        }
    }

    /** Of headings one in some five thousand: the series takes a hundred times as long. */
    @Test
    void theSeriesIsNeededRarely(TestReporter report) {
        int left = 0;
        int count = 1_000_000;
        for (int k = 0; k < count; k++) {
            angles.sineHead = Double.NaN;
            angles.turn((random.nextDouble() - 0.5) * 20);
            left += Double.isNaN(angles.sineHead) ? 0 : 1;
        }
        report.publishEntry("seed " + SEED + ": " + left + " of " + count + " headings left to the series");
        assertTrue(left < count / 3000, "left to the series: " + left);
    }

    /** Bits are equal on every JDK, whatever its flags: -Xint, -XX:TieredStopAtLevel=1, -XX:-UseFMA. */
    @Test
    void theBitsOfAFixedSetOfAnglesAreGolden() {
        SplitMix64 fixed = new SplitMix64(2024);
        StateHash hash = new StateHash();
        for (int k = 0; k < 100_000; k++) {
            angles.turn((fixed.nextDouble() - 0.5) * 40);
            hash.add(angles.sin()).add(angles.cos());
            angles.turn(Numbers.any(fixed, -40, 1023));
            hash.add(angles.sin()).add(angles.cos());
        }
        assertEquals("06deb82ed6c87877", StateHash.toHex(hash.value()));
    }

    @Test
    void nothingIsAllocated() {
        double[] some = new double[2000];
        for (int k = 0; k < some.length; k++) {
            some[k] = angle();
        }
        Allocated.assertNone(20, some.length + " angles", () -> Allocated.by(() -> {
            for (double angle : some) {
                angles.turn(angle);
                bySeries.turn(angle);
            }
        }));
    }
}
