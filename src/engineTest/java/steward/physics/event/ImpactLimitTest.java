package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** Turns with more impacts than any bound: each ends, says so, and leaves a world that can go on. */
@Execution(ExecutionMode.CONCURRENT)
class ImpactLimitTest {

    private static final double INFINITY = Double.POSITIVE_INFINITY;

    /** Plays turns and checks after each: numbers, overlaps, and energies where no infinite mass works. */
    private static int play(Bodies bodies, EventAdvance advance, int turns, boolean energyMayGrow, Runnable push,
                            Wall... walls) {
        int limited = 0;
        for (int turn = 0; turn < turns; turn++) {
            push.run();
            double energy = Scenes.energy(bodies);
            TurnLog log = Scenes.turn(advance, bodies);
            assertTrue(Scenes.allFinite(bodies), "turn " + turn);
            assertTrue(Scenes.deepestOverlap(bodies, walls) <= 1e-9,
                "turn " + turn + ": overlap " + Scenes.deepestOverlap(bodies, walls));
            assertTrue(energyMayGrow || Scenes.energy(bodies) <= energy * (1 + 1e-12), "turn " + turn);
            assertEquals(log.limited(), log.limitTime() >= 0 && log.limitTime() <= 1, "turn " + turn);
            assertEquals(log.limited(), log.limitBodies().length > 0, "turn " + turn);
            limited += log.limited() ? 1 : 0;
        }
        return limited;
    }

    /**
     * Below e = 7 - 4 sqrt(3) = 0.0718 three bodies in a line collide without end in a finite time (S. McNamara,
     * W. R. Young, "Inelastic collapse and clumping in a one-dimensional granular medium", 1992). Each round leaves a
     * fixed share of the speeds, so that doubles run out of digits after some dozens of impacts, unless the bound comes
     * first. The law of the scene knows no rest. Then the three are squeezed further each turn, then thrown at a wall.
     * <pre>
     *     |  O-->   O   <--O  |
     * </pre>
     */
    @Test
    @Tag("slow")
    @Tag("sized")
    void anInelasticCollapseBetweenWallsEnds() {
        int turns = TestSize.of(40, 200);
        for (int bound : new int[] {0, 12}) {
            Wall[] walls = Wall.box(100, 1000, 0.05);
            Bodies bodies = new Bodies(3);
            for (int k = 0; k < 3; k++) {
                Scenes.add(bodies, 20 + 30 * k, 500, 400 * (1 - k), 0, 1);
                bodies.setRestitution(k, 0.05);
            }
            EventAdvance advance = Scenes.advance(
                Scenes.WITH_RESTITUTION.withRestSpeed(0).withMaximumImpacts(bound), walls);
            TurnLog log = Scenes.turn(advance, bodies);
            assertTrue(log.impacts() >= 12, log.impacts() + " impacts: no collapse");
            assertEquals(bound == 12, log.limited());
            assertEquals(bound == 12 ? 3 : 0, log.limitBodies().length, "all three are in the heap");
            int limited = play(bodies, advance, turns, false, () -> {
                bodies.vx[0] += 100;
                bodies.vx[2] -= 100;
            }, walls);
            assertTrue(bound == 0 || limited > turns / 2, "limited " + limited);
            play(bodies, advance, turns, false, () -> {
                for (int k = 0; k < 3; k++) {
                    bodies.vx[k] += 50 + 7 * k;
                }
            }, walls);
        }
    }

    /** A stack on a floor, pulled down each turn, with nothing that lifts it but e. */
    @Test
    void aStackRestsOnAFloor() {
        for (double e : new double[] {0, 0.05, 0.5, 0.9}) {
            Wall[] floor = {new HalfPlane(0, 0, 0, 1, e)};
            Bodies bodies = new Bodies(4);
            for (int k = 0; k < 4; k++) {
                Scenes.add(bodies, 0.5 * k, 10 + 20.5 * k, 0, 0, 1 + k);
                bodies.setRestitution(k, e);
            }
            int limited = play(bodies, Scenes.advance(Scenes.WITH_RESTITUTION, floor), 150, false, () -> {
                for (int k = 0; k < 4; k++) {
                    bodies.vy[k] -= 9.81;
                }
            }, floor);
            assertEquals(0, limited, "it rests, e " + e);
        }
    }

    /**
     * Two infinite masses close in on a body. It goes back and forth faster and faster until there is no room; then all
     * three stand for the rest of the turn, named.
     * <pre>
     *     R-->  O  <--R
     * </pre>
     */
    @Test
    @Tag("slow")
    @Tag("sized")
    void anImpossibleSqueezeStandsStill() {
        int turns = TestSize.of(5, 200);
        for (double e : new double[] {0, 0.5, 1}) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 30, 0, INFINITY}, {40, 0, 5, 0},
                {80, 0, -30, 0, INFINITY}, {40, 500, 25, 0}});
            bodies.setRestitution(1, e);
            TurnLog log = new TurnLog();
            EventAdvance advance = Scenes.advance(Scenes.WITH_RESTITUTION);
            advance.turn(bodies, log);
            assertTrue(log.limited(), "e " + e);
            assertEquals(2.0 / 3, log.limitTime(), 0.01, "40 u of room at 60 u per turn");
            assertArrayEquals(new int[] {0, 1, 2}, log.limitBodies());
            assertEquals(30, bodies.vx[0], "speeds stay");
            assertEquals(-30, bodies.vx[2]);
            assertEquals(65, bodies.x[3], 1e-9, "who is not concerned flies on");
            assertEquals(turns, play(bodies, advance, turns, true, () -> { }), "so it is every turn");
            assertTrue(bodies.x[2] - bodies.x[0] >= 40 - 1e-9, "e " + e + ": " + (bodies.x[2] - bodies.x[0]));
            assertEquals(65 + turns * 25, bodies.x[3], 1e-6);
        }
    }

    /** An infinite mass presses a body against a wall. */
    @Test
    void aBodyPressedAgainstAWallStandsStill() {
        Wall[] floor = {new HalfPlane(0, 0, 0, 1, 1)};
        Bodies bodies = Scenes.bodies(new double[][] {{0, 15, 0, 0}, {0, 45, 0, -30, INFINITY}});
        int limited = play(bodies, Scenes.advance(ImpactLaw.PHYSICS, floor), 20, true, () -> { }, floor);
        assertEquals(20, limited);
    }

    /**
     * Along a round wall each impact is weaker by e and the next one nearer by e: infinitely many in a finite time.
     * They end in a slide, and the body keeps the speed that it then has along the wall: 50 u a turn on a circle of
     * 990 u.
     */
    @Test
    void aBodyThatSlidesAlongARoundWallWithoutFullRestitutionKeepsItsSpeed() {
        for (double e : new double[] {0, 0.5, 0.9}) {
            Wall[] walls = {new Arena(0, 0, 1000, e)};
            Bodies bodies = Scenes.bodies(new double[] {989, 0, 1, 50});
            int limited = play(bodies, Scenes.advance(Scenes.WITH_RESTITUTION, walls), 100, false, () -> { }, walls);
            assertEquals(0, limited, "e " + e);
            double angle = Math.atan2(bodies.y[0], bodies.x[0]);
            assertEquals(Math.IEEEremainder(100 * 50.0 / 990, 2 * Math.PI), angle, 0.02, "e " + e);
        }
    }

    /** With a bound of 3 the fourth impact of a chain does not happen: its two stand, the rest flies on. */
    @Test
    void theBoundIsTheLawsAndItsEndIsNamed() {
        Bodies bodies = Scenes.bodies(new double[][] {{900, 900, 1, 1}, {0, 0, 400, 0}, {60, 0, 0, 0}, {120, 0, 0, 0},
            {180, 0, 0, 0}, {240, 0, 0, 0}});
        bodies.remove(0);
        TurnLog log = Scenes.turn(Scenes.advance(ImpactLaw.PHYSICS.withMaximumImpacts(3)), bodies);
        assertEquals(3, log.impacts());
        assertTrue(log.limited());
        assertEquals(0.3, log.limitTime(), 1e-12, "when the fourth was looked for");
        assertArrayEquals(new int[] {4, 5}, log.limitBodies());
        assertEquals(220, bodies.x[3], 1e-9, "it flew up to its neighbour");
        assertEquals(400, bodies.vx[3], 1e-9, "and keeps its speed");
        assertEquals(240, bodies.x[4], 1e-9);
        assertEquals(4, log.knotBody(log.knots() - 2), "their paths end there");
        assertEquals(5, log.knotBody(log.knots() - 1));
        log.clear();
        assertFalse(log.limited());
        assertEquals(0, log.limitBodies().length);
        Scenes.advance(ImpactLaw.PHYSICS).turn(bodies, log);
        assertEquals(400, bodies.vx[4], 1e-9, "the next turn has the impact");
    }

    /** Ninety bodies that fill 80 percent of a box, e = 0.95. */
    @Test
    void ninetyDenseBodiesLoseEnergyAndNothingElse() {
        Wall[] walls = Wall.box(1000, 1000, 0.95);
        Bodies bodies = Scenes.grid(new SplitMix64(1), 10, 1000, 48, 150);
        while (bodies.size() > 90) {
            bodies.remove(bodies.size() / 2);
        }
        Scenes.setRestitution(bodies, 0.95);
        double before = Scenes.energy(bodies);
        play(bodies, Scenes.advance(Scenes.WITH_RESTITUTION, walls), 8, false, () -> { }, walls);
        assertTrue(Scenes.energy(bodies) < before / 2, "hundreds of impacts at 0.95");
    }

    /** Random crowds of sticky, bouncy, heavy and immovable bodies, pulled together each turn. */
    @Test
    void crowdsPulledTogetherNeverHangNorOverlap() {
        int limited = 0;
        for (long seed = 1; seed <= 25; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Wall[] walls = {new Arena(500, 500, 700, random.nextInt(3) / 2.0)};
            Bodies bodies = Scenes.grid(random, 3, 1000, 80, 300);
            for (int k = 0; k < 9; k++) {
                bodies.setRestitution(k, random.nextInt(5) / 4.0);
            }
            bodies.setMass(random.nextInt(9), INFINITY);
            bodies.setVelocity(heaviest(bodies), 0, 0);
            limited += play(bodies, Scenes.advance(Scenes.WITH_RESTITUTION, walls), 30, false, () -> {
                for (int k = 0; k < 9; k++) {
                    if (bodies.inverseMass[k] > 0) {
                        bodies.vx[k] += (500 - bodies.x[k]) / 5;
                        bodies.vy[k] += (500 - bodies.y[k]) / 5;
                    }
                }
            }, walls);
        }
        assertEquals(0, limited, "of 750 turns ended by the bound");
    }

    private static int heaviest(Bodies bodies) {
        int heaviest = 0;
        for (int k = 1; k < bodies.size(); k++) {
            heaviest = bodies.mass[k] > bodies.mass[heaviest] ? k : heaviest;
        }
        return heaviest;
    }
}
