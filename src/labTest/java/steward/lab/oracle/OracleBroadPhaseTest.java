package steward.lab.oracle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.Segment;
import steward.physics.Wall;

/** The oracle that leaves out by bounds against the one that examines everything: the same impacts, digit by digit. */
@Execution(ExecutionMode.CONCURRENT)
class OracleBroadPhaseTest {

    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM)
        .withRestSpeed(0);
    private static final int MOST_IMPACTS = 40;

    /**
     * <pre>
     *   +---------------+
     *   |  o o o   o    |   A box with a slanted plane and a segment in it, an arena around all; discs as a lattice
     *   |  o o o  / O   |   whose neighbours touch, of very unequal sizes and masses, some at rest, one infinite.
     *   +--------/------+
     * </pre>
     *
     * @param size  of the box
     * @param from  the origin's distance from its corner, in sizes
     * @param touch the share of the lattice's step that a disc's diameter takes; 1 touches, above it overlaps
     */
    @ParameterizedTest
    @CsvSource({"1000, 0, 1", "1e-80, 0, 0.9"})
    @Tag("slow")
    @Tag("sized")
    void boundsChangeNoDigit(double size, double from, double touch) {
        compare(size, from, touch);
    }

    @ParameterizedTest
    @Tag("campaign")
    @CsvSource({"1000, 0, 0.5", "1000, 0, 0.999999999999", "1000, 0, 1.01", "1e-7, 0, 0.9", "1e7, 0, 1",
        "1, 1e6, 0.9", "1, -1e9, 1", "1e40, 3, 1"})
    void boundsOfOtherSizesChangeNoDigit(double size, double from, double touch) {
        compare(size, from, touch);
    }

    private static void compare(double size, double from, double touch) {
        for (int seed = 1; seed <= TestSize.of(1, 4); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = crowd(random, size, from * size, touch);
            ImpactLaw law = (seed % 2 == 0 ? SOFT : seed == 1 ? ImpactLaw.PHYSICS : ImpactLaw.OFFICIAL_POD_RACE)
                .withMaximumImpacts(MOST_IMPACTS);
            List<Wall> walls = walls(size, from * size);
            List<OracleBody> fast = OracleBody.of(bodies);
            List<OracleBody> slow = OracleBody.of(bodies);
            List<OracleImpact> expected = new Oracle(law, walls).examiningAll().turn(slow);
            assertEquals(expected, new Oracle(law, walls).turn(fast), "seed " + seed);
            assertEquals(states(slow), states(fast), "seed " + seed);
            assertTrue(expected.size() > 2, "seed " + seed + ": " + expected.size());
        }
    }

    private static List<Object> states(List<OracleBody> bodies) {
        List<Object> all = new ArrayList<>();
        bodies.forEach(body -> all.addAll(List.of(body.x, body.y, body.vx, body.vy)));
        return all;
    }

    private static Bodies crowd(SplitMix64 random, double size, double from, double touch) {
        Bodies bodies = new Bodies(12);
        double step = size / 8;
        for (int k = 0; k < 12; k++) {
            double radius = step * touch / 2 * (random.nextInt(4) == 0 ? 1e-3 : 1);
            bodies.add(from + step * (1 + k % 4), from + step * (1 + k / 4), radius,
                k == 5 ? Double.POSITIVE_INFINITY : StrictMath.pow(10, random.nextInt(-3, 4)));
            double speed = random.nextInt(3) == 0 ? 0 : size * StrictMath.pow(10, random.nextInt(-2, 1));
            bodies.setVelocity(k, k == 5 ? 0 : speed * (random.nextDouble() - 0.5),
                k == 5 ? 0 : speed * (random.nextDouble() - 0.5));
            bodies.setRestitution(k, random.nextDouble());
        }
        return bodies;
    }

    private static List<Wall> walls(double size, double from) {
        List<Wall> walls = new ArrayList<>();
        walls.add(new HalfPlane(from, from, 1, 0, 1));
        walls.add(new HalfPlane(from, from, 0, 1, 0.5));
        walls.add(new HalfPlane(from + size, from + size, -0.6, -0.8, 0.5));
        walls.add(new Arena(from + size / 2, from + size / 2, 0.6 * size, 0.7));
        walls.add(new Segment(from + 0.6 * size, from + 0.1 * size, from + 0.7 * size, from + 0.9 * size, 0.5));
        return walls;
    }
}
