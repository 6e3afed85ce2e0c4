package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;

/**
 * Perfectly inelastic impacts: the approach ends at once and for good, whatever rounding leaves of it. Two circles that
 * have met and slide along each other part (the distance along a straight flight is convex), so each pair has one
 * impact a turn; a body that slides along a straight wall stays at it.
 */
class InelasticTest {

    /** A fast body hits a slow one, anywhere on its front. Equal normal speeds afterwards: the mean by mass. */
    @Test
    void twoBodiesMeetOnceAndSlideApart() {
        for (long seed = 1; seed <= 3000; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = new Bodies(2);
            bodies.add(0, 0, 400, 1 + random.nextInt(3) * random.nextDouble());
            bodies.add(900 + 2000 * random.nextDouble(), 1200 * (random.nextDouble() - 0.5), 400,
                1 + random.nextInt(10));
            bodies.setVelocity(0, 4000 + 2000 * random.nextDouble(), 100 * (random.nextDouble() - 0.5));
            bodies.setVelocity(1, -100 * random.nextDouble(), 100 * (random.nextDouble() - 0.5));
            bodies.setRestitution(1, 0);
            TurnLog log = Scenes.turn(Scenes.advance(Scenes.WITH_RESTITUTION), bodies);
            assertEquals(1, log.impacts(), "seed " + seed);
            Impact i = log.impact(0);
            double parting = (i.vbxAfter() - i.vaxAfter()) * i.normalX() + (i.vbyAfter() - i.vayAfter()) * i.normalY();
            assertEquals(0, parting, 32 * Math.ulp(6000.0), "seed " + seed);
            assertTrue(Scenes.deepestOverlap(bodies) <= 1e-9, "seed " + seed);
        }
    }

    /** Along a tilted wall for five turns: the speed along it stays, the place beside it stays. */
    @Test
    void aBodySlidesAlongAWall() {
        for (long seed = 1; seed <= 2000; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double angle = 2 * Math.PI * random.nextDouble();
            double lean = 2.8 * (random.nextDouble() - 0.5);
            HalfPlane wall = new HalfPlane(0, 0, Math.cos(angle), Math.sin(angle), 0);
            checkSlide(wall, 2000 * Math.cos(angle), 2000 * Math.sin(angle), 3000, angle + lean, lean, seed);
        }
    }

    /** Along a segment for five turns, and off its end, which must not catch the body. */
    @Test
    void aBodySlidesAlongASegmentAndOffItsEnd() {
        for (long seed = 1; seed <= 2000; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double angle = 2 * Math.PI * random.nextDouble();
            double lean = 0.5 + 0.8 * random.nextDouble();
            double half = 3000;
            Segment wall = new Segment(half * Math.sin(angle), -half * Math.cos(angle),
                -half * Math.sin(angle), half * Math.cos(angle), 0);
            checkSlide(wall, 700 * Math.cos(angle), 700 * Math.sin(angle), 5000, angle + lean, lean, seed);
        }
    }

    private static void checkSlide(Wall wall, double x, double y, double speed, double from, double lean, long seed) {
        Bodies bodies = Scenes.bodies(new double[][] {
            {x, y, -speed * Math.cos(from), -speed * Math.sin(from), 1, 400}});
        EventAdvance advance = Scenes.advance(Scenes.WITH_RESTITUTION, wall);
        TurnLog log = new TurnLog();
        for (int turn = 0; turn < 5; turn++) {
            advance.turn(bodies, log);
            assertFalse(log.limited(), "seed " + seed + " turn " + turn);
            assertTrue(-wall.gap(bodies.x[0], bodies.y[0], 400) <= 1e-9, "seed " + seed + " turn " + turn);
        }
        assertTrue(log.impacts() >= 1 && log.impacts() <= 10, "seed " + seed + ": " + log.impacts() + " impacts");
        assertEquals(Math.abs(speed * Math.sin(lean)), Math.hypot(bodies.vx[0], bodies.vy[0]), 1e-9, "seed " + seed);
    }

    /**
     * Official law: a meets b 3e-6 turns before the floor, which is one batch. The impulse of b along n = (0.8, -0.6)
     * turns a upward: j = 30 / 1.1 + 120 = 147, vy = -50 + 0.6 * 147 = 38. A wall only reacts to approach.
     * <pre>
     *        a |            a: radius 400, 25 above the floor, 50 u per turn down
     *          v  b         b: radius 100, on the floor, heavy
     *     -----------
     * </pre>
     */
    @Test
    void aWallDoesNotPullWhoWasTurnedRoundInTheSameBatch() {
        PhysicsParts parts = Scenes.parts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL,
            new HalfPlane(0, 0, 0, 1, 1));
        Bodies bodies = Scenes.bodies(new double[][] {{0, 425, 0, -50, 1, 400}, {400 - 1e-4, 100, 0, 0, 10, 100}});
        TurnLog log = Scenes.turn(new EventAdvance(parts), bodies);
        for (int k = 0; k < log.impacts(); k++) {
            assertTrue(!log.impact(k).isWall() || log.impact(k).impulse() > 0, "impact " + k + " " + log.impact(k));
        }
        assertTrue(bodies.vy[0] > 30, "vy " + bodies.vy[0]);
    }
}
