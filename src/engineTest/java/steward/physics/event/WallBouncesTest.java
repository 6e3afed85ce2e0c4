package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.match.Refusal.refused;

import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;

/** Walls over many turns: nobody leaves, nobody gains or loses speed for nothing. */
class WallBouncesTest {

    private static final double NAN = Double.NaN;

    /** With e = 1 each bounce only turns the sign of one component, so even every bit of the speed stays. */
    @Test
    void aPodBetweenFourWallsKeepsItsSpeedForTenThousandTurns() {
        Wall[] walls = Wall.box(16000, 9000, 1);
        EventAdvance advance = Scenes.advance(ImpactLaw.PHYSICS, walls);
        int bounces = 0;
        for (long seed = 1; seed <= 5; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double mass = 1 + random.nextInt(10);
            Bodies bodies = Scenes.bodies(new double[][] {
                {8000, 4500, 5000 * random.nextDouble(), 3000 * random.nextDouble(), mass, 400}});
            double speed = Math.hypot(bodies.vx[0], bodies.vy[0]);
            for (int turn = 0; turn < 10_000; turn++) {
                TurnLog log = Scenes.turn(advance, bodies);
                assertFalse(log.limited());
                bounces += log.impacts();
                assertEquals(speed, Math.hypot(bodies.vx[0], bodies.vy[0]), 1e-12 * speed, "seed " + seed);
                assertTrue(Scenes.deepestOverlap(bodies, walls) <= 1e-9, "seed " + seed + " turn " + turn);
            }
        }
        assertTrue(bounces > 10_000, bounces + " bounces");
    }

    /**
     * One bounce rounds the speed by a few 2^-53, in random directions: 3,000 of them by about
     * sqrt(3000) * 4 * 1.1e-16 = 2.4e-14, and never by 3000 * 8 * 1.1e-16 = 2.6e-12.
     */
    @Test
    void wallsOfEveryKindKeepTheSpeedToRounding() {
        checkSpeedAndPlace(tiltedSquare(), 3700);
        checkSpeedAndPlace(new Wall[] {new Arena(0, 0, 3000, 1)}, 3000);
        checkSpeedAndPlace(pen(), 4000);
    }

    /** Normals that no double holds exactly. */
    private static Wall[] tiltedSquare() {
        Wall[] walls = new Wall[4];
        for (int k = 0; k < 4; k++) {
            double nx = Math.cos(0.4 + k * Math.PI / 2);
            double ny = Math.sin(0.4 + k * Math.PI / 2);
            walls[k] = new HalfPlane(-3000 * nx, -3000 * ny, nx, ny, 1);
        }
        return walls;
    }

    /** Segments, open at no corner: the round ends of the walls meet there. */
    private static Wall[] pen() {
        double[][] corners = {{-2500, -2000}, {2700, -2300}, {3000, 1500}, {200, 2900}, {-2900, 1700}};
        Wall[] walls = new Wall[5];
        for (int k = 0; k < 5; k++) {
            double[] b = corners[(k + 1) % 5];
            walls[k] = new Segment(corners[k][0], corners[k][1], b[0], b[1], 1);
        }
        return walls;
    }

    private static void checkSpeedAndPlace(Wall[] walls, double reach) {
        EventAdvance advance = Scenes.advance(ImpactLaw.PHYSICS, walls);
        for (long seed = 1; seed <= 5; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = Scenes.bodies(new double[][] {{100 * random.nextDouble(), 100 * random.nextDouble(),
                3000 * random.nextDouble() - 1500, 3000 * random.nextDouble() - 1500, 1, 400}});
            double speed = Math.hypot(bodies.vx[0], bodies.vy[0]);
            int bounces = 0;
            while (bounces < 3000) {
                TurnLog log = Scenes.turn(advance, bodies);
                assertFalse(log.limited(), "seed " + seed + " after " + bounces);
                bounces += log.impacts();
                assertTrue(Math.hypot(bodies.x[0], bodies.y[0]) < reach, "seed " + seed + " left after " + bounces);
                assertTrue(Scenes.deepestOverlap(bodies, walls) <= 1e-9, "seed " + seed + " after " + bounces);
            }
            assertEquals(speed, Math.hypot(bodies.vx[0], bodies.vy[0]), 2.6e-12 * speed, "seed " + seed);
        }
    }

    /** Sixteen bodies of different masses: the sum of energies stays, to 1e-11 after some ten thousand impacts. */
    @Test
    void manyBodiesInABoxConserveEnergy() {
        Wall[] walls = Wall.box(1000, 1000, 1);
        EventAdvance advance = Scenes.advance(ImpactLaw.PHYSICS, walls);
        for (long seed = 1; seed <= 5; seed++) {
            Bodies bodies = Scenes.grid(new SplitMix64(seed), 4, 1000, 60, 500);
            double energy = Scenes.energy(bodies);
            int impacts = 0;
            for (int turn = 0; turn < 100; turn++) {
                TurnLog log = Scenes.turn(advance, bodies);
                impacts += log.impacts();
                assertFalse(log.limited(), "seed " + seed);
                assertEquals(energy, Scenes.energy(bodies), 1e-11 * energy, "seed " + seed + " turn " + turn);
                assertTrue(Scenes.deepestOverlap(bodies, walls) <= 1e-9, "seed " + seed + " turn " + turn);
            }
            assertTrue(impacts > 1000, impacts + " impacts");
        }
    }

    /**
     * Within 1e-12 a vector counts as a unit vector; taken as it is, 1 + 9e-13 would speed a body up by 4 * 9e-13 a
     * bounce, 3.6e-9 in a thousand.
     */
    @Test
    void aNormalWrittenWithTwelveDigitsSpeedsNobodyUp() {
        double x = 0.7071067811872;
        Wall[] walls = {new HalfPlane(-100, -100, x, x, 1), new HalfPlane(100, 100, -x, -x, 1)};
        EventAdvance advance = Scenes.advance(ImpactLaw.PHYSICS, walls);
        Bodies bodies = Scenes.bodies(new double[] {0, 0, 400, 300});
        for (int turn = 0; turn < 1000; turn++) {
            advance.turn(bodies, TurnSink.NONE);
        }
        assertEquals(500, Math.hypot(bodies.vx[0], bodies.vy[0]), 500 * 1e-12);
    }

    @Test
    void badWallsAreRefusedByName() {
        refused("wall: length of the inside vector 5.0, expected 1", () -> new HalfPlane(0, 0, 3, 4, 1));
        refused("wall: length of the inside vector NaN, expected 1", () -> new HalfPlane(0, 0, NAN, 0, 1));
        refused("wall: x NaN, expected a finite number", () -> new HalfPlane(NAN, 0, 1, 0, 1));
        refused("wall: y Infinity, expected a finite number",
            () -> new HalfPlane(0, Double.POSITIVE_INFINITY, 1, 0, 1));
        refused("wall: restitution 1.5, expected 0..1", () -> new HalfPlane(0, 0, 1, 0, 1.5));
        refused("wall: length of a segment 0.0, expected finite and above 0", () -> new Segment(1, 2, 1, 2, 1));
        refused("wall: length of a segment NaN, expected finite and above 0", () -> new Segment(1, NAN, 1, 2, 1));
        refused("wall: restitution NaN, expected 0..1", () -> new Segment(1, 2, 3, 4, NAN));
        refused("wall: radius 0.0, expected finite and above 0", () -> new Arena(0, 0, 0, 1));
        refused("wall: x NaN, expected a finite number", () -> new Arena(NAN, 0, 1, 1));
        refused("wall: restitution -0.5, expected 0..1", () -> new Arena(0, 0, 1, -0.5));
        refused("wall: width -1.0, expected finite and above 0", () -> Wall.box(-1, 1, 1));
        refused("wall: height NaN, expected finite and above 0", () -> Wall.box(1, NAN, 1));
    }

    /** Each wall's own geometry: the gap, and the normal that points straight to it. */
    @Test
    void gapsAndNormals() {
        check(new HalfPlane(5, 0, -1, 0, 1), 2, 7, 1, 2, 1, 0);
        check(new Segment(0, 0, 10, 0, 1), 4, 3, 1, 2, 0, -1);
        check(new Segment(0, 0, 10, 0, 1), 13, -4, 1, 4, -0.6, 0.8);
        check(new Arena(0, 0, 10, 1), 3, 4, 1, 4, 0.6, 0.8);
        check(new Arena(0, 0, 10, 1), 0, 0, 1, 9, 1, 0);
    }

    private static void check(Wall wall, double x, double y, double radius, double gap, double nx, double ny) {
        assertEquals(gap, wall.gap(x, y, radius), 1e-15, wall.toString());
        assertEquals(nx, wall.normalX(x, y), 1e-15, wall.toString());
        assertEquals(ny, wall.normalY(x, y), 1e-15, wall.toString());
    }
}
