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
import steward.physics.HalfPlane;
import steward.physics.Segment;

/**
 * Circle against half-plane and segment, against 60 digits. With u = 2^-53, M the sum of all lengths that enter and w
 * the speed toward the wall at the touch, each place is known to about 8 u M and each time to 32 u M / w; a miss or a
 * hit is certain where it is the same with a radius 32 u M smaller and larger.
 */
@Execution(ExecutionMode.CONCURRENT)
class FlatWallTimesTest {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final int CASES = 4_000;

    @Test
    @Tag("sized")
    void halfPlaneTimesAreExactToTheBound() {
        int hits = 0;
        for (long seed = 1; seed <= TestSize.of(1000, CASES); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double size = Math.pow(10, 24 * random.nextDouble() - 12);
            double angle = 2 * Math.PI * random.nextDouble();
            HalfPlane plane = new HalfPlane(size * random.nextDouble(), size * random.nextDouble(),
                Math.cos(angle), Math.sin(angle), 1);
            double x = size * (4 * random.nextDouble() - 2);
            double y = size * (4 * random.nextDouble() - 2);
            double vx = size * (2 * random.nextDouble() - 1);
            double vy = size * (2 * random.nextDouble() - 1);
            double radius = size * Math.pow(10, -6 * random.nextDouble());
            BigDecimal gap = Exact.of(x).subtract(Exact.of(plane.x())).multiply(Exact.of(plane.insideX()))
                .add(Exact.of(y).subtract(Exact.of(plane.y())).multiply(Exact.of(plane.insideY())))
                .subtract(Exact.of(radius));
            BigDecimal closing = Exact.dot(vx, vy, plane.insideX(), plane.insideY()).negate();
            double lengths = 8 * size;
            double found = TimeOfImpact.wall(plane, x, y, vx, vy, radius);
            String what = "seed " + seed + " found " + found;
            if (closing.abs().doubleValue() < 8 * Exact.ULP * size) {
                continue;
            }
            if (closing.signum() < 0) {
                assertEquals(NEVER, found, what);
            } else if (gap.doubleValue() < -32 * Exact.ULP * lengths) {
                assertEquals(0, found, what);
            } else {
                BigDecimal exact = gap.divide(closing, Exact.DIGITS);
                double bound = 32 * Exact.ULP * (lengths + exact.abs().doubleValue() * size) / closing.doubleValue();
                assertTrue(Exact.error(found, exact) <= bound, what + " exact " + exact.doubleValue());
                hits++;
            }
        }
        assertTrue(hits > TestSize.of(175, 700), hits + " hits");
    }

    /** A circle, its flight and a segment, with the exact first touch from the definition. */
    private record Flight(double x, double y, double vx, double vy, double radius,
                          double ax, double ay, double bx, double by) {

        static Flight of(long seed) {
            SplitMix64 random = new SplitMix64(seed);
            double size = Math.pow(10, 24 * random.nextDouble() - 12);
            double speed = size * Math.pow(10, 6 * random.nextDouble() - 3);
            double[] r = new double[8];
            for (int k = 0; k < r.length; k++) {
                r[k] = 2 * random.nextDouble() - 1;
            }
            double aim = 2.2 * random.nextDouble() - 0.6;                    // where on the line, mostly on the segment
            double ax = size * r[0];
            double ay = size * r[1];
            double bx = size * r[2];
            double by = size * r[3];
            double x = size * 3 * r[4];
            double y = size * 3 * r[5];
            double vx = speed * (ax + aim * (bx - ax) - x) / size;
            double vy = speed * (ay + aim * (by - ay) - y) / size;
            return new Flight(x, y, vx, vy, size * Math.pow(10, -4 * random.nextDouble()), ax, ay, bx, by);
        }

        double found() {
            return TimeOfImpact.wall(new Segment(ax, ay, bx, by, 1), x, y, vx, vy, radius);
        }

        double lengths() {
            return Math.hypot(x - ax, y - ay) + Math.hypot(bx - ax, by - ay) + radius;
        }

        double speed() {
            return Math.hypot(vx, vy);
        }

        /**
         * The first t > 0 at which the centre is exactly r away from the segment, coming from farther away: of the
         * crossings of the two parallels those beside the segment, of those of the two end circles those beyond it.
         */
        BigDecimal exact(BigDecimal r) {
            BigDecimal length = Exact.root(Exact.dot(bx - ax, by - ay, bx - ax, by - ay));
            BigDecimal side = cross(Exact.of(x).subtract(Exact.of(ax)), Exact.of(y).subtract(Exact.of(ay)));
            BigDecimal rise = cross(Exact.of(vx), Exact.of(vy));
            BigDecimal first = null;
            for (int sign = -1; sign <= 1 && rise.signum() != 0; sign += 2) {
                BigDecimal level = r.multiply(length).multiply(BigDecimal.valueOf(sign));
                first = earlier(first, level.subtract(side).divide(rise, Exact.DIGITS), 0);
            }
            first = earlierOfEnd(first, ax, ay, r, -1);
            return earlierOfEnd(first, bx, by, r, 1);
        }

        private BigDecimal earlierOfEnd(BigDecimal first, double endX, double endY, BigDecimal r, int beyond) {
            BigDecimal[] times = Exact.crossings(x - endX, y - endY, vx, vy, r);
            return times == null ? first : earlier(earlier(first, times[0], beyond), times[1], beyond);
        }

        /** @param beyond where the centre's foot on the line must be: -1 before a, 0 between, 1 behind b */
        private BigDecimal earlier(BigDecimal first, BigDecimal time, int beyond) {
            BigDecimal foot = foot(time);
            BigDecimal full = Exact.dot(bx - ax, by - ay, bx - ax, by - ay);
            int where = foot.signum() < 0 ? -1 : foot.compareTo(full) > 0 ? 1 : 0;
            return where != beyond || time.signum() < 0 || first != null && first.compareTo(time) <= 0 ? first : time;
        }

        private BigDecimal foot(BigDecimal time) {
            BigDecimal cx = Exact.of(x).add(Exact.of(vx).multiply(time)).subtract(Exact.of(ax));
            BigDecimal cy = Exact.of(y).add(Exact.of(vy).multiply(time)).subtract(Exact.of(ay));
            return cx.multiply(Exact.of(bx - ax)).add(cy.multiply(Exact.of(by - ay)));
        }

        private BigDecimal cross(BigDecimal px, BigDecimal py) {
            return Exact.of(bx - ax).multiply(py).subtract(Exact.of(by - ay).multiply(px));
        }

        /** The speed toward the nearest point of the segment at a time. */
        double closing(double time) {
            Segment segment = new Segment(ax, ay, bx, by, 1);
            double cx = x + vx * time;
            double cy = y + vy * time;
            return vx * segment.normalX(cx, cy) + vy * segment.normalY(cx, cy);
        }

        /** True if the circle starts clear of the segment. */
        boolean startsApart() {
            return new Segment(ax, ay, bx, by, 1).gap(x, y, radius) > 1e-9 * lengths();
        }
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void segmentTimesAreExactToTheBound() {
        int cases = TestSize.of(CASES / 5, CASES);
        int[] touched = new int[3];
        int misses = 0;
        for (long seed = 1; seed <= cases; seed++) {
            Flight f = Flight.of(seed);
            if (!f.startsApart()) {
                continue;
            }
            double found = f.found();
            double slack = 32 * Exact.ULP * f.lengths();
            BigDecimal exact = f.exact(Exact.of(f.radius));
            boolean hit = exact != null;
            boolean certain = hit == (f.exact(Exact.of(f.radius - slack)) != null)
                && hit == (f.exact(Exact.of(f.radius + slack)) != null);
            if (!certain) {
                continue;
            }
            String what = "seed " + seed;
            assertEquals(hit, found < NEVER, () -> what + " " + f + " found " + found);
            if (!hit) {
                misses++;
                continue;
            }
            double closing = f.closing(exact.doubleValue());
            double share = closing / f.speed();
            if (share * share > 256 * Exact.ULP * f.lengths() / f.radius) {
                double bound = slack / closing;
                double error = Exact.error(found, exact);
                assertTrue(error <= bound, () -> what + " " + f + ": error " + error + ", bound " + bound);
                BigDecimal foot = f.foot(exact);
                touched[foot.signum() < 0 ? 0
                    : foot.compareTo(Exact.dot(f.bx - f.ax, f.by - f.ay, f.bx - f.ax, f.by - f.ay)) > 0 ? 2 : 1]++;
            }
        }
        assertTrue(touched[0] > cases / 27 && touched[1] > cases / 4 && touched[2] > cases / 27 && misses > cases / 27,
            "end a " + touched[0] + ", sides " + touched[1] + ", end b " + touched[2] + ", misses " + misses);
    }

    /**
     * <pre>
     *            o  (4, 7)
     *            |          radius 2, wall from (0, 0) to (10, 0)
     *     A------+--------B
     *            |
     *            o  (4, -7)
     * </pre>
     */
    @Test
    void bothSidesAndBothEndsOfASegment() {
        Segment wall = new Segment(0, 0, 10, 0, 1);
        assertEquals(5, TimeOfImpact.wall(wall, 4, 7, 0, -1, 2), "from above");
        assertEquals(5, TimeOfImpact.wall(wall, 4, -7, 0, 1, 2), "from below");
        assertEquals(5, TimeOfImpact.wall(wall, 0, 7, 0, -1, 2), "exactly at end a");
        assertEquals(5, TimeOfImpact.wall(wall, 10, -7, 0, 1, 2), "exactly at end b");
        assertEquals(3, TimeOfImpact.wall(wall, -5, 0, 1, 0, 2), "end on, at a");
        assertEquals(3, TimeOfImpact.wall(wall, 15, 0, -1, 0, 2), "end on, at b");
        assertEquals(1, TimeOfImpact.wall(wall, -3, 5, 0, -1, 5), 4 * Math.ulp(1.0), "(-3, 4) is 5 from a");
        assertEquals(1, TimeOfImpact.wall(wall, 13, -5, 0, 1, 5), 4 * Math.ulp(1.0), "(13, -4) is 5 from b");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 12, 7, 0, -1, 2), "passes b at its radius: a tangent is a miss");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 4, 2, 1, 0, 2), "along the wall, touching");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 4, 7, 0, 1, 2), "recedes");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 4, 7, 0, 0, 2), "stands still");
    }

    @Test
    void whoTouchesASegmentHitsAtOnceIfApproaching() {
        Segment wall = new Segment(0, 0, 10, 0, 1);
        assertEquals(0, TimeOfImpact.wall(wall, 4, 2, 3, -1, 2), "touching");
        assertEquals(0, TimeOfImpact.wall(wall, 4, -1, 3, 1, 2), "overlapping from below");
        assertEquals(0, TimeOfImpact.wall(wall, 12, 0, -1, 5, 2), "touching end b");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 4, 1, 3, 1, 2), "overlapping, recedes");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 11, 0, 1, 1, 2), "overlapping end b, recedes");
    }

    /** The distance to a segment along a straight flight is convex: who recedes from it never comes back. */
    @Test
    void whoRecedesFromOneSideDoesNotRunIntoAnEndOfIt() {
        Segment wall = new Segment(0, 0, 100, 0, 1);
        assertEquals(NEVER, TimeOfImpact.wall(wall, 50, 9.99, 100, 0.001, 10),
            "toward b, an overlap of 0.01 shrinking");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 50, -9.99, -100, -0.001, 10), "toward a, from below");
        assertEquals(NEVER, TimeOfImpact.wall(wall, 50, 9.99, 100, 0, 10), "along the wall");
    }

    /** Whole-number flights at a half-plane; gap / closing is one exact division. */
    @Test
    void halfPlanesByHand() {
        HalfPlane floor = new HalfPlane(0, 0, 0, 1, 1);
        assertEquals(2, TimeOfImpact.wall(floor, 7, 5, 9, -2, 1));
        assertEquals(0, TimeOfImpact.wall(floor, 7, 1, 9, -2, 1), "touching, approaches");
        assertEquals(0, TimeOfImpact.wall(floor, 7, 0.5, 9, -2, 1), "overlapping, approaches");
        assertEquals(NEVER, TimeOfImpact.wall(floor, 7, 1, 9, 2, 1), "touching, recedes");
        assertEquals(NEVER, TimeOfImpact.wall(floor, 7, 0.5, 9, 0, 1), "overlapping, along");
        assertEquals(NEVER, TimeOfImpact.wall(floor, 7, 5, 0, 0, 1), "stands still");
    }
}
