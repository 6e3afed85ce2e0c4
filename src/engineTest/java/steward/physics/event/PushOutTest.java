package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.physics.impulse.Collision;

/**
 * How far touching bodies are moved apart after an impact, and that the paths show it.
 *
 * <pre>
 *     (a (  ) b)      radius 10 each, 12 apart: overlap 8; with epsilon 1 each moves 8 / 2 + 1 = 5
 * </pre>
 */
class PushOutTest {

    private static final ImpactLaw PUSH = ImpactLaw.PHYSICS.withPushOut(1);

    private static TurnLog react(Bodies bodies, int b, Wall... walls) {
        TurnLog log = new TurnLog();
        new Collision(PUSH, walls).react(bodies, 0, b, 0.5, log);
        return log;
    }

    private static Bodies overlapping(double massA, double massB) {
        Bodies bodies = Scenes.bodies(new double[][] {{500, 500, 0, 0}, {100, 100, 3, 4, massA},
            {112, 100, 0, 0, massB}});
        bodies.remove(0);
        return bodies;
    }

    /** A knot as body, time, x, y. */
    private static double[] knot(TurnLog log, int k) {
        return new double[] {log.knotBody(k), log.knotTime(k), log.knotX(k), log.knotY(k)};
    }

    @Test
    void halfOfTheOverlapEach() {
        Bodies bodies = overlapping(1, 7);
        TurnLog log = react(bodies, 1);
        assertArrayEquals(new double[] {95, 100, 117, 100},
            new double[] {bodies.x[0], bodies.y[0], bodies.x[1], bodies.y[1]});
        assertEquals(100, log.impact(0).ax(), "the record says where it was");
        assertEquals(112, log.impact(0).bx());
        assertEquals(4, log.knots());
        assertArrayEquals(new double[] {1, 0.5, 100, 100}, knot(log, 0));
        assertArrayEquals(new double[] {2, 0.5, 112, 100}, knot(log, 1));
        assertArrayEquals(new double[] {1, 0.5, 95, 100}, knot(log, 2));
        assertArrayEquals(new double[] {2, 0.5, 117, 100}, knot(log, 3));
    }

    @Test
    void allOfItToTheMovableOne() {
        Bodies rockRight = overlapping(1, Double.POSITIVE_INFINITY);
        TurnLog log = react(rockRight, 1);
        assertEquals(90, rockRight.x[0]);
        assertEquals(112, rockRight.x[1]);
        assertEquals(3, log.knots(), "the rock has no second knot");
        assertArrayEquals(new double[] {1, 0.5, 90, 100}, knot(log, 2));
        Bodies rockLeft = overlapping(Double.POSITIVE_INFINITY, 1);
        assertArrayEquals(new double[] {2, 0.5, 122, 100}, knot(react(rockLeft, 1), 2));
        assertEquals(100, rockLeft.x[0]);
    }

    /** Exactly touching counts as touching; apart does not. */
    @Test
    void onlyWhoTouchesIsPushed() {
        Bodies touching = overlapping(1, 1);
        touching.setPosition(1, 120, 100);
        assertEquals(4, react(touching, 1).knots());
        assertEquals(99, touching.x[0]);
        assertEquals(121, touching.x[1]);
        Bodies apart = overlapping(1, 1);
        apart.setPosition(1, Math.nextUp(120), 100);
        assertEquals(2, react(apart, 1).knots());
        assertEquals(100, apart.x[0]);
    }

    /** Centre 7 above the floor with radius 10: 3 deep, pushed 3 + 2 * 1 as against a rock. */
    @Test
    void allOfItAwayFromAWall() {
        Bodies bodies = Scenes.bodies(new double[] {50, 7, 1, -1});
        TurnLog log = react(bodies, ~0, new HalfPlane(0, 0, 0, 1, 1));
        assertEquals(12, bodies.y[0]);
        assertArrayEquals(new double[] {0, 0.5, 50, 7}, knot(log, 0));
        assertArrayEquals(new double[] {0, 0.5, 50, 12}, knot(log, 1));
        bodies.setPosition(0, 50, 10.5);
        bodies.setVelocity(0, 1, -1);
        assertEquals(1, react(bodies, ~0, new HalfPlane(0, 0, 0, 1, 1)).knots(), "half a u above the floor");
    }

    @Test
    void noneUnlessTheLawSaysSo() {
        Bodies bodies = overlapping(1, 1);
        TurnLog log = new TurnLog();
        new Collision(ImpactLaw.PHYSICS, new Wall[0]).react(bodies, 0, 1, 0.5, log);
        assertEquals(2, log.knots());
        assertEquals(100, bodies.x[0]);
    }
}
