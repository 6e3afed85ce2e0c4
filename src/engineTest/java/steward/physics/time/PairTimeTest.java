package steward.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * Pairs that are left out for their distance have no impact within a turn in the arithmetic itself: with and without
 * the reject, decisions and times are the same to the bit.
 */
@Execution(ExecutionMode.CONCURRENT)
class PairTimeTest {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final Arithmetic[] ARITHMETICS = {Arithmetic.OFFICIAL, Arithmetic.DOUBLE, Arithmetic.COMPENSATED};
    private static final int CASES = 20_000;

    private int left;
    private int late;
    private int hits;

    /** Flights that would touch near the end of a turn, central or grazing, from contact to far away. */
    @Test
    void flightsThatArriveAboutTheEndOfTheTurn() {
        compareAll(1, random -> {
            double gap = StrictMath.pow(10, -17 * random.nextDouble());
            double offset = random.nextInt(2) == 0 ? 0 : Math.min(1, near(random));
            double along = Math.sqrt((1 + gap) * (1 + gap) - offset * offset);
            double inside = Math.sqrt(1 - offset * offset);
            double speed = (along - inside) * near(random);
            return pair(random, 1 + gap, speed * along / (1 + gap), speed * offset / (1 + gap));
        });
        assertTrue(hits > CASES && late > 1000, hits + " hits, " + late + " late");
    }

    /** Approach at which c + 2 b is nearly 0, also with speeds far above the distance across it. */
    @Test
    void approachAtTheEdgeOfTheReject() {
        compareAll(2, random -> {
            double distance = 1 + StrictMath.pow(10, -14 * random.nextDouble());
            double c = distance * distance - 1;
            double across = random.nextInt(3) == 0 ? 0 : StrictMath.pow(10, 20 * random.nextDouble() - 10);
            return pair(random, distance, c / 2 / distance * near(random), across);
        });
        assertTrue(left > CASES && late > 100, left + " left out, " + late + " late");
    }

    @Test
    void anything() {
        compareAll(3, random -> pair(random, StrictMath.pow(10, 8 * random.nextDouble() - 1),
            StrictMath.pow(10, 12 * random.nextDouble() - 6) * (random.nextInt(4) == 0 ? -1 : 1),
            StrictMath.pow(10, 12 * random.nextDouble() - 6)));
        assertTrue(left > CASES && hits > CASES / 20, left + " left out, " + hits + " hits");
    }

    /** 1, or off it by 1e-1 to 1e-16. */
    private static double near(SplitMix64 random) {
        double off = StrictMath.pow(10, -1 - 15 * random.nextDouble());
        return random.nextInt(8) == 0 ? 1 : random.nextInt(2) == 0 ? 1 + off : 1 - off;
    }

    /** Two bodies that touch at distance 1, times a scale, with a relative velocity towards each other and across. */
    private static Bodies pair(SplitMix64 random, double distance, double approach, double across) {
        double angle = 2 * Math.PI * random.nextDouble();
        double ux = StrictMath.cos(angle);
        double uy = StrictMath.sin(angle);
        double size = Math.scalb(1 + random.nextDouble(), random.nextInt(-20, 20));
        double far = random.nextInt(3) == 0 ? size * StrictMath.pow(10, 4 * random.nextDouble()) : 0;
        double share = random.nextDouble();
        Bodies bodies = new Bodies(2);
        bodies.add(far + size * distance * ux, size * distance * uy - far, size * share, 1);
        bodies.add(far, -far, size * (1 - share), 1);
        bodies.setVelocity(0, size * (-approach * ux - across * uy), size * (-approach * uy + across * ux));
        return bodies;
    }

    private interface Source {
        Bodies draw(SplitMix64 random);
    }

    private void compareAll(long seed, Source source) {
        SplitMix64 random = new SplitMix64(seed);
        for (int n = 0; n < CASES; n++) {
            Bodies bodies = source.draw(random);
            for (Arithmetic arithmetic : ARITHMETICS) {
                compare(arithmetic, ImpactLaw.PHYSICS, bodies, seed, n);
                compare(arithmetic, ImpactLaw.OFFICIAL_POD_RACE, bodies, seed, n);
            }
        }
    }

    private void compare(Arithmetic arithmetic, ImpactLaw law, Bodies b, long seed, int n) {
        double plain = CircleTime.of(arithmetic).until(b.x[0], b.x[1], b.y[0], b.y[1], b.vx[0], b.vx[1], b.vy[0],
            b.vy[1], b.radius[0], b.radius[1], law.separatingPairsReact());
        double seen = PairTime.of(law, arithmetic).until(b, 0, 1, b.radius[0], b.radius[1]);
        if (plain <= 1 || seen < NEVER) {
            assertEquals(plain, seen, () -> "seed " + seed + ", case " + n + ", " + arithmetic);
        }
        hits += plain <= 1 ? 1 : 0;
        left += seen == NEVER ? 1 : 0;
        late += seen == NEVER && plain < NEVER ? 1 : 0;
    }
}
