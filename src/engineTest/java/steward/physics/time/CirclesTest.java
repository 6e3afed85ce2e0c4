package steward.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/**
 * Circle and circle, against 60 digits.
 *
 * <pre>
 *        v          p: how far the line of flight passes from the other centre
 *     o----->....   s: the touching distance; a hit if p < s
 *        d    p |   cos: of the angle between v and the normal at the touch, sqrt(1 - p^2/s^2)
 *               O
 * </pre>
 *
 * <p>The bound. With u = 2^-53 and d for |d|: the distance is wrong by at most 2 u d, which moves the touch by
 * 2 u d / cos; offset and touch distance put at most 6 u d |v| into each factor of the discriminant, which moves it by
 * 6 u d / cos; d.v is wrong by at most 2 u d |v|, moving it by 2 u d; six more roundings of the result are 6 u d. So
 * |v| |t - exact| <= 16 u d / cos as long as the first order counts, cos^2 > 64 u d / s. Hit or miss is decided by
 * |v| s - |d x v|, wrong by at most 6 u d |v|: certain unless |p - s| <= 8 u d.
 */
@Execution(ExecutionMode.CONCURRENT)
class CirclesTest {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final int CASES = 8_000;

    /** One seeded case: sizes over 24 decades, from just apart to a million radii away, aimed from centre to edge. */
    private record Case(double dx, double dy, double vx, double vy, double s) {

        static Case of(long seed) {
            SplitMix64 random = new SplitMix64(seed);
            double s = Math.pow(10, 24 * random.nextDouble() - 12);
            double apart = 1 + Math.pow(10, 20 * random.nextDouble() - 14);
            double speed = Math.pow(10, 24 * random.nextDouble() - 12);
            double direction = 2 * Math.PI * random.nextDouble();
            double near = Math.pow(10, -13 * random.nextDouble()) * (random.nextInt(2) - 0.5);
            double aim = random.nextInt(4) == 0 ? 1 + near : 1.3 * random.nextDouble();
            double angle = direction + Math.PI + Math.asin(Math.min(1, aim / apart)) * (2 * random.nextInt(2) - 1);
            return new Case(s * apart * Math.cos(direction), s * apart * Math.sin(direction),
                speed * Math.cos(angle), speed * Math.sin(angle), s);
        }

        double distance() {
            return Math.hypot(dx, dy);
        }

        double miss() {
            return Exact.root(Exact.nearestSquared(dx, dy, vx, vy).max(BigDecimal.ZERO)).doubleValue();
        }
    }

    @Test
    @Tag("sized")
    void timesAreWithinTheDerivedBoundAndDecisionsRight() {
        int cases = TestSize.of(CASES / 5, CASES);
        int hits = 0;
        int misses = 0;
        int undecided = 0;
        for (long seed = 1; seed <= cases; seed++) {
            Case c = Case.of(seed);
            double found = CircleTime.stable(c.dx, c.dy, c.vx, c.vy, c.s);
            BigDecimal[] exact = Exact.crossings(c.dx, c.dy, c.vx, c.vy, Exact.of(c.s));
            boolean hit = exact != null && exact[0].signum() > 0;
            if (Math.abs(c.miss() - c.s) <= 8 * Exact.ULP * c.distance()
                || c.distance() - c.s <= 8 * Exact.ULP * c.distance()) {
                undecided++;
                continue;
            }
            String what = "seed " + seed;
            assertEquals(hit, found < NEVER, () -> what + " " + c + " found " + found);
            if (hit) {
                hits++;
                checkTime(c, found, exact[0], seed);
            } else {
                misses++;
            }
        }
        assertTrue(hits > cases / 2 && misses > cases / 8 && undecided < cases / 20,
            hits + " hits, " + misses + " misses, " + undecided + " undecided");
    }

    private static void checkTime(Case c, double found, BigDecimal exact, long seed) {
        double share = c.miss() / c.s;
        double cosSquared = (1 - share) * (1 + share);
        if (cosSquared > 64 * Exact.ULP * c.distance() / c.s) {
            double bound = 16 * Exact.ULP * c.distance() / Math.sqrt(cosSquared) / Math.hypot(c.vx, c.vy);
            double error = Exact.error(found, exact);
            assertTrue(error <= bound, () -> "seed " + seed + " " + c + ": error " + error + ", bound " + bound);
        }
    }

    /** In the band the decision may go either way, but a time that is given is near the point of closest approach. */
    @Test
    @Tag("sized")
    void aGrazingHitIsNearTheClosestApproach() {
        int grazing = 0;
        for (long seed = 1; seed <= TestSize.of(2000, CASES); seed++) {
            Case c = Case.of(seed);
            double found = CircleTime.stable(c.dx, c.dy, c.vx, c.vy, c.s);
            if (Math.abs(c.miss() - c.s) <= 8 * Exact.ULP * c.distance() && found < NEVER) {
                double nearest = Exact.nearestTime(c.dx, c.dy, c.vx, c.vy).doubleValue();
                double early = Math.sqrt(32 * Exact.ULP * c.distance() * c.s) / Math.hypot(c.vx, c.vy);
                assertEquals(nearest, found, early + 1e-15 * nearest, "seed " + seed + " " + c);
                grazing++;
            }
        }
        assertTrue(grazing > TestSize.of(2, 8), grazing + " grazing");
    }

    /** By hand. Along an axis everything is exact; elsewhere a root of a whole number is rounded. */
    @Test
    void flightsByHand() {
        assertEquals(2, CircleTime.stable(7, 0, -2, 0, 3), "7 - 2 * 2 = 3, head on");
        assertEquals(1, CircleTime.stable(12, 5, -8, 0, Math.sqrt(41)), 4 * Math.ulp(1.0), "(4, 5) is so far away");
        assertEquals(0.5, CircleTime.stable(6, 4, -6, 0, 5), 4 * Math.ulp(0.5), "(3, 4) is 5 away");
        assertEquals(NEVER, CircleTime.stable(10, 5, -1, 0, 5), "passes at 5: a tangent is a miss");
        assertEquals(NEVER, CircleTime.stable(10, 6, -1, 0, 5), "passes at 6");
        assertEquals(NEVER, CircleTime.stable(7, 0, 2, 0, 3), "recedes");
        assertEquals(NEVER, CircleTime.stable(7, 0, 0, 3, 3), "neither comes nor goes");
        assertEquals(NEVER, CircleTime.stable(7, 0, 0, 0, 3), "stands still");
    }

    @Test
    void whoTouchesHitsAtOnceIfApproaching() {
        assertEquals(0, CircleTime.stable(3, 4, -1, -1, 5), "touching");
        assertEquals(0, CircleTime.stable(3, 4, -1, -1, 6), "overlapping");
        assertEquals(0, CircleTime.stable(3, 4, -1e-300, 0, 6), "however slowly");
        assertEquals(NEVER, CircleTime.stable(3, 4, 1, 1, 5), "touching, recedes");
        assertEquals(NEVER, CircleTime.stable(3, 4, 1, 1, 6), "overlapping, recedes");
        assertEquals(NEVER, CircleTime.stable(3, 4, -4, 3, 5), "touching, along the edge");
        assertEquals(NEVER, CircleTime.stable(3, 4, 0, 0, 5), "touching, at rest");
        assertEquals(NEVER, CircleTime.stable(0, 0, 1, 0, 5), "concentric: every way is out");
    }

    private static double official(double dx, double dy, double vx, double vy, double s) {
        return CircleTime.official(dx, dy, vx, vy, dx * dx + dy * dy - s * s);
    }

    /** The expressions of DESIGN, "Official pod-race turn" 2, in their order. */
    private static double asDesigned(double dx, double dy, double vx, double vy, double s) {
        double a = vx * vx + vy * vy;
        double b = dx * vx + dy * vy;
        double c = dx * dx + dy * dy - s * s;
        double d = b * b - a * c;
        if (d <= 0 || a == 0) {
            return NEVER;
        }
        double root = Math.min((-b + Math.sqrt(d)) / a, (-b - Math.sqrt(d)) / a);
        return 0 < root ? root : NEVER;
    }

    @Test
    @Tag("sized")
    void theOfficialExpressionsBitForBit() {
        int hits = 0;
        for (long seed = 1; seed <= TestSize.of(2000, CASES); seed++) {
            Case c = Case.of(seed);
            double expected = asDesigned(c.dx, c.dy, c.vx, c.vy, c.s);
            assertEquals(expected, official(c.dx, c.dy, c.vx, c.vy, c.s), "seed " + seed);
            assertEquals(expected, official(-c.dx, -c.dy, -c.vx, -c.vy, c.s), "seed " + seed);
            hits += expected < NEVER ? 1 : 0;
        }
        assertTrue(hits > TestSize.of(750, 3000), hits + " hits");
    }

    /**
     * Two pods 10,000 u apart at 1 u per turn: (distance - 800)(distance + 800) and its square cancel about five
     * digits in the official expressions; the stable ones keep them. The exact time from 60 digits decides.
     */
    @Test
    void theOfficialExpressionsLoseDigitsThatTheStableOnesKeep() {
        double official = official(9800.1, 700.3, -1.7, -0.1, 800);
        double stable = CircleTime.stable(9800.1, 700.3, -1.7, -0.1, 800);
        BigDecimal exact = Exact.crossings(9800.1, 700.3, -1.7, -0.1, Exact.of(800))[0];
        assertNotEquals(official, stable);
        assertTrue(Exact.error(stable, exact) <= Math.ulp(stable), "stable: " + Exact.error(stable, exact));
        assertTrue(Exact.error(official, exact) > 5 * Math.ulp(stable), "official: " + Exact.error(official, exact));
    }

    /** They can even miss altogether: from a million radii away the official discriminant is all rounding. */
    @Test
    void farAwayTheOfficialExpressionsDecideWrongly() {
        int wrong = 0;
        for (long seed = 1; seed <= 2000; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double aim = 1.8 * random.nextDouble() - 0.9;
            double dx = 1e9 * (1 + random.nextDouble());
            boolean stable = CircleTime.stable(dx, aim, -1, 0, 1) < NEVER;
            assertTrue(stable, "seed " + seed);
            wrong += official(dx, aim, -1, 0, 1) < NEVER ? 0 : 1;
        }
        assertTrue(wrong > 100, wrong + " of 2000 hits missed");
    }
}
