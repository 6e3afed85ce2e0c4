package steward.lab.oracle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.lab.oracle.OracleProjection.Condition;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.Scenes;

/** Heaps at rest in the oracle, against closed forms and against the exact rung, which computes them in another way. */
@Execution(ExecutionMode.CONCURRENT)
class OracleHeapTest {

    private static final BigDecimal TINY = new BigDecimal("1e-30");
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    private static void assertNear(double expected, BigDecimal found) {
        assertTrue(Decimals.of(expected).subtract(found).abs().compareTo(TINY) < 0, () -> expected + ", got " + found);
    }

    private static Condition condition(int a, int b, double nx, double ny, double limit) {
        return new Condition(a, b, Decimals.of(nx), Decimals.of(ny), Decimals.of(limit));
    }

    private static OracleProjection projection(double[] masses, double... velocities) {
        Bodies bodies = new Bodies(masses.length);
        BigDecimal[] x = new BigDecimal[masses.length];
        BigDecimal[] y = new BigDecimal[masses.length];
        for (int k = 0; k < masses.length; k++) {
            bodies.add(100 * k, 0, 1, masses[k]);
            x[k] = Decimals.of(velocities[2 * k]);
            y[k] = Decimals.of(velocities[2 * k + 1]);
        }
        return new OracleProjection(OracleBody.of(bodies), x, y);
    }

    /** Masses 1 and 3: together at a quarter of the speed; at most 2 apart, at 2.5 and 0.5; before a wall at 0. */
    @Test
    void theNearestVelocitiesOfTwoByHand() {
        double[] masses = {1, 3};
        OracleProjection two = projection(masses, 4, 1, 0, 2);
        assertTrue(two.solve(List.of(condition(0, 1, 1, 0, 0))));
        assertNear(1, two.x[0]);
        assertNear(1, two.x[1]);
        assertNear(1, two.y[0]);
        assertTrue(two.solve(List.of(condition(0, 1, 1, 0, 2))));
        assertNear(2.5, two.x[0]);
        assertNear(0.5, two.x[1]);
        List<Condition> wall = List.of(condition(0, 1, 1, 0, 0), condition(1, ~0, 1, 0, 0));
        assertTrue(two.solve(wall));
        assertNear(0, two.x[0]);
        assertNear(0, two.x[1]);
        assertNear(4, wall.get(1).impulse);
    }

    /** Three walls of which one repeats what the others say, then a gap that no speed fits. */
    @Test
    void conditionsMayDependOnEachOtherButNotContradict() {
        OracleProjection one = projection(new double[] {2}, 3, 5);
        assertTrue(one.solve(List.of(condition(0, ~0, 0.6, 0.8, 0), condition(0, ~1, 1, 0, 0),
            condition(0, ~2, 0, 1, 0))));
        assertNear(0, one.x[0]);
        assertNear(0, one.y[0]);
        assertFalse(one.solve(List.of(condition(0, ~0, 1, 0, -1), condition(0, ~1, -1, 0, -1))));
        Condition held = condition(0, ~0, 1, 0, 8);
        held.equal = true;
        assertTrue(one.solve(List.of(held)));
        assertNear(8, one.x[0]);
        assertNear(-10, held.impulse);
    }

    /** Three in a row, the outer ones at equal speeds: all that they lose is lost, and they stand still. */
    @Test
    void aRowThatMeetsHeadOnStandsStill() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 1000, 0}, {100, 0, 0, 0}, {200, 0, -1000, 0}});
        Scenes.setRestitution(bodies, 0.05);
        Oracle oracle = new Oracle(SOFT, List.of());
        List<OracleBody> after = OracleBody.of(bodies);
        assertTrue(oracle.turn(after).size() < 40, "until 2^-40 of the energy is left");
        assertFalse(oracle.limited());
        after.forEach(body -> assertTrue(body.vx.abs().doubleValue() < 1e-3, "keeps " + body.vx));
    }

    /** A disc that moves along a rim would bounce without end: its chords are none of the truth. */
    @Test
    void aDiscThatSlidesAlongARimStopsTheOracle() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 90, 50, 0}});
        bodies.setRestitution(0, 0.5);
        Oracle oracle = new Oracle(SOFT, List.of(new Arena(0, 0, 100, 1)));
        oracle.turn(OracleBody.of(bodies));
        assertTrue(oracle.rested());
        bodies.setVelocity(0, 50, 50);
        Oracle bouncing = new Oracle(SOFT, List.of(new Arena(0, 0, 100, 1)));
        bouncing.turn(OracleBody.of(bodies));
        assertFalse(bouncing.limited());
    }

    /** Discs fall into a wedge, a box and an arena, 60 turns; a path in the arena ends on its rim to 2^-40 of it. */
    @ParameterizedTest
    @CsvSource({"wedge, 0, 1e-9", "wedge, 0.6, 1e-9", "box, 0.3, 1e-9", "arena, 0.3, 4e-6"})
    @Tag("slow")
    void aHeapThatComesToRestIsThatOfTheExactRung(String place, double restitution, double most) {
        List<Wall> walls = switch (place) {
            case "wedge" -> List.of(new HalfPlane(0, 0, 0.6, -0.8, 1), new HalfPlane(0, 0, -0.28, -0.96, 1));
            case "box" -> List.of(Wall.box(-40, -400, 80, 400, 1));
            default -> List.of(new Arena(0, -110, 110, 1));
        };
        SplitMix64 random = new SplitMix64(7);
        Forces gravity = new Forces(0, 0, 0, 2);
        Bodies bodies = new Bodies(7);
        for (int k = 0; k < 7; k++) {
            bodies.add(10 * random.nextDouble() - 5, -60 - 15 * k, 7, 1 + random.nextDouble());
            bodies.setRestitution(k, restitution);
        }
        PhysicsParts parts = new PhysicsParts(SOFT, Arithmetic.EXACT, new Contacts(1), walls, null, false)
            .withForces(gravity);
        EventAdvance exact = new EventAdvance(parts);
        int compared = 0;
        for (int turn = 0; turn < 60; turn++) {
            Scenes.accelerate(gravity, bodies);
            List<OracleBody> truth = OracleBody.of(bodies);
            Oracle oracle = Oracle.of(parts, bodies);
            oracle.turn(truth);
            exact.turn(bodies, TurnSink.NONE);
            for (int k = 0; k < bodies.size() && !oracle.limited(); k++) {
                compared++;
                assertEquals(truth.get(k).x.doubleValue(), bodies.x[k], 20 * most, "turn " + turn);
                assertEquals(truth.get(k).vy.doubleValue(), bodies.vy[k], 20 * most, "turn " + turn);
            }
        }
        assertTrue(compared > 7 * 50, compared + " of " + 7 * 60);
    }
}
