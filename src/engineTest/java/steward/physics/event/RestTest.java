package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.HalfPlane;
import steward.physics.Impact;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** Bodies that press against a wall come to rest instead of bouncing until the bound on impacts, on every rung. */
@Execution(ExecutionMode.CONCURRENT)
class RestTest {

    private static List<Advance> both(Arithmetic arithmetic, Wall... walls) {
        return Scenes.both(Scenes.parts(Scenes.WITH_RESTITUTION, arithmetic, walls));
    }

    /** Bodies one above the other, which touch each other and the floor. */
    private static Bodies column(int count, double vy, double restitution) {
        Bodies bodies = new Bodies(count);
        for (int k = 0; k < count; k++) {
            Scenes.add(bodies, 0, 10 + 20 * k, 0, vy, 1);
        }
        Scenes.setRestitution(bodies, restitution);
        return bodies;
    }

    /** Thirty bodies in rows from a corner on, with a gap and up to so much play between them. */
    private static Bodies rows(int perRow, double gap, double play, double restitution) {
        SplitMix64 random = new SplitMix64(26);
        Bodies bodies = new Bodies(30);
        for (int k = 0; k < 30; k++) {
            double x = 10 + (20 + gap) * (k % perRow) + (perRow == 1 ? 0 : play * random.nextDouble());
            Scenes.add(bodies, x, 10 + (20 + gap) * (k / perRow) + play * random.nextDouble(), 0, 0,
                1 + 2 * random.nextDouble());
        }
        Scenes.setRestitution(bodies, restitution);
        return bodies;
    }

    private static HalfPlane floor(double restitution) {
        return new HalfPlane(0, 0, 0, 1, restitution);
    }

    /**
     * The wall takes both: first the lower one, then both together. Momentum 2 * 20 goes into the wall, nothing is
     * left, and a third body far away flies on.
     * <pre>
     *      O  v = -20        O  v = -20
     *      O  v = -20
     *    -----
     * </pre>
     */
    @ParameterizedTest
    @EnumSource
    void twoBodiesOnAWallWithoutRestitutionRest(Arithmetic arithmetic) {
        for (Advance advance : both(arithmetic, floor(0))) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 10, 0, -20}, {0, 30, 0, -20}, {500, 500, 0, -20}});
            Scenes.setRestitution(bodies, 0);
            TurnLog log = Scenes.turn(advance, bodies);
            assertTrue(log.impacts() <= 5, log.impacts() + " impacts");
            double intoWall = 0;
            for (int k = 0; k < log.impacts(); k++) {
                intoWall += log.impact(k).isWall() ? log.impact(k).momentumBy() : 0;
            }
            assertEquals(-40, intoWall, 1e-9);
            assertEquals(0, bodies.vy[0], 1e-10);
            assertEquals(0, bodies.vy[1], 1e-10);
            assertEquals(480, bodies.y[2], 1e-12, "it has nothing to do with the two");
            log.clear();
            advance.turn(bodies, log);
            assertEquals(0, log.impacts(), "they rest");
            assertEquals(460, bodies.y[2], 1e-12);
        }
    }

    /**
     * Body 3 stood on two others, and is removed together with 2 a moment before they meet the floor: it is no part of
     * their heap.
     * <pre>
     *      3 &lt;-2
     *      1
     *      0
     *    -----
     * </pre>
     */
    @ParameterizedTest
    @EnumSource
    void aBodyThatAReactionHasRemovedIsNoPartOfAHeap(Arithmetic arithmetic) {
        Contacts contacts = new Contacts(2).set(1, 1, Contacts.Meaning.ASK);
        PhysicsParts parts = new PhysicsParts(Scenes.WITH_RESTITUTION, arithmetic, contacts, List.of(floor(0)),
            (time, a, b, bodies, sink) -> {
                bodies.remove(3);
                bodies.remove(2);
                return Reaction.Verdict.CHANGED;
            }, true);
        for (Advance advance : Scenes.both(parts)) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 12.000002, 0, -20}, {0, 32.000003, 0, -20},
                {40, 52.000004, -200, -20}, {0, 52.000004, 0, -20}});
            for (int k = 0; k < 4; k++) {
                bodies.setRestitution(k, 0);
                bodies.setKind(k, k / 2);
            }
            TurnLog log = Scenes.turn(advance, bodies);
            assertEquals(2, bodies.size());
            assertTrue(log.impacts() >= 2 && log.impacts() <= 5, log.impacts() + " impacts");
            for (int k = 0; k < log.impacts(); k++) {
                assertTrue(log.impact(k).a() < 2 && log.impact(k).b() < 2, log.impact(k)::toString);
            }
        }
    }

    /**
     * Within a heap that rests, all impulses are exchanged at one time, ascending by ids, walls last, one for each
     * contact.
     */
    @ParameterizedTest
    @EnumSource
    void aChainIsSolvedAsOneInTheOrderOfIds(Arithmetic arithmetic) {
        for (Advance advance : both(arithmetic, floor(0))) {
            Bodies bodies = column(5, -20, 0);
            for (int k = 0; k < 5; k++) {
                bodies.setMass(k, 1 + k);
            }
            TurnLog log = Scenes.turn(advance, bodies);
            int last = log.impacts() - 1;
            assertEquals("0-1 0--1 1-2 2-3 3-4", pairs(log, last - 4, last));
            assertEquals(log.impact(last - 4).time(), log.impact(last).time());
            for (int k = 0; k < 5; k++) {
                assertEquals(0, bodies.vy[k], 1e-10, "body " + k);
            }
        }
    }

    private static String pairs(TurnLog log, int from, int to) {
        StringBuilder text = new StringBuilder();
        for (int k = from; k <= to; k++) {
            Impact impact = log.impact(k);
            text.append(k == from ? "" : " ").append(impact.a()).append('-').append(impact.b());
        }
        return text.toString();
    }

    /** Thirty in a column with gaps up to 0.5: the number of impacts, and the energy. */
    @ParameterizedTest
    @EnumSource
    void thirtyBodiesWithGapsRest(Arithmetic arithmetic) {
        for (Advance advance : both(arithmetic, floor(0))) {
            SplitMix64 random = new SplitMix64(30);
            Bodies bodies = new Bodies(30);
            double y = 10;
            for (int k = 0; k < 30; k++) {
                Scenes.add(bodies, 0, y, 0, -20, 1);
                bodies.setRestitution(k, 0);
                y += 20 + 0.5 * random.nextDouble();
            }
            double before = Scenes.energy(bodies);
            for (int turn = 0; turn < 5; turn++) {
                double energy = Scenes.energy(bodies);
                TurnLog log = Scenes.turn(advance, bodies);
                assertFalse(log.limited());
                assertTrue(log.impacts() <= 500, log.impacts() + " impacts");
                assertTrue(Scenes.energy(bodies) <= energy);
            }
            assertTrue(Scenes.energy(bodies) <= 1e-20 * before);
        }
    }

    /** Three bodies with e = 0.3, pressed against a wall each turn: some hundred impacts leave 2^-40 of the energy. */
    @ParameterizedTest
    @EnumSource
    void bodiesThatCollapseRestAtAShareOfTheirEnergy(Arithmetic arithmetic) {
        for (double heavy : new double[] {1, 3}) {
            for (Advance advance : both(arithmetic, floor(0.3))) {
                Bodies bodies = column(3, 0, 0.3);
                bodies.setMass(1, heavy);
                bodies.setMass(2, heavy);
                for (int turn = 0; turn < 20; turn++) {
                    for (int k = 0; k < 3; k++) {
                        bodies.vy[k] -= 20;
                    }
                    TurnLog log = Scenes.turn(advance, bodies);
                    assertTrue(!log.limited() && log.impacts() <= 1000, log.impacts() + " impacts");
                }
            }
        }
    }

    /**
     * A body between two walls that are narrower than itself: it stays where it is, and keeps its speed along them. Its
     * impacts end when 2^-20 of its speed is left, for e = 0.9 after 132.
     */
    @ParameterizedTest
    @EnumSource
    void aBodyBetweenWallsThatAreTooNarrowRests(Arithmetic arithmetic) {
        for (double e : new double[] {0, 0.3, 0.9}) {
            for (Advance advance : both(arithmetic, new HalfPlane(0, 0, 1, 0, e), new HalfPlane(19, 0, -1, 0, e))) {
                Bodies bodies = Scenes.bodies(new double[] {9.5, 0, 7, 3});
                bodies.setRestitution(0, e);
                for (int turn = 1; turn <= 3; turn++) {
                    TurnLog log = Scenes.turn(advance, bodies);
                    assertTrue(!log.limited() && log.impacts() <= 132, "e " + e + ": " + log.impacts() + " impacts");
                    assertEquals(0, bodies.vx[0], "e " + e);
                    assertEquals(3.0 * turn, bodies.y[0], 1e-12, "e " + e);
                }
            }
        }
    }

    /** A ball that bounces between two walls has room: it keeps bouncing with e, however often. */
    @ParameterizedTest
    @EnumSource
    void aBallBetweenWallsWithRoomBounces(Arithmetic arithmetic) {
        for (Advance advance : both(arithmetic, new HalfPlane(0, 0, 1, 0, 0.9), new HalfPlane(30, 0, -1, 0, 0.9))) {
            Bodies bodies = Scenes.bodies(new double[] {10, 0, 100, 3});
            bodies.setRestitution(0, 0.9);
            TurnLog log = Scenes.turn(advance, bodies);
            assertEquals(100 * Math.pow(0.9, log.impacts()), Math.abs(bodies.vx[0]), 1e-9);
            assertTrue(log.impacts() >= 6, log.impacts() + " impacts");
        }
    }

    /**
     * A law's own rest speed: with 0 the heap bounces on, with one above all speeds it rests after its first impacts.
     */
    @ParameterizedTest
    @EnumSource
    void aLawMayNameTheRestSpeed(Arithmetic arithmetic) {
        int[] impacts = new int[2];
        for (int k = 0; k < 2; k++) {
            PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION.withRestSpeed(k == 0 ? 0 : 100), arithmetic,
                floor(0.5));
            Bodies bodies = column(3, -20, 0.5);
            TurnLog log = Scenes.turn(new EventAdvance(parts), bodies);
            impacts[k] = log.impacts();
            double after = Math.abs(bodies.vy[0]) + Math.abs(bodies.vy[1]) + Math.abs(bodies.vy[2]);
            assertTrue(k == 0 ? after > 1 : after < 1e-9, "speeds " + after);
        }
        assertTrue(impacts[1] <= 6 && impacts[0] > impacts[1], impacts[0] + " and " + impacts[1] + " impacts");
    }

    /** Thirty without restitution in a corner, in rows of five or one above the other, pressed into it each turn. */
    @ParameterizedTest
    @EnumSource
    void pilesPressedIntoACornerTakeAtMost500ImpactsATurn(Arithmetic arithmetic) {
        for (int perRow : new int[] {1, 5}) {
            for (Advance advance : both(arithmetic, floor(0), new HalfPlane(0, 0, 1, 0, 0))) {
                Bodies bodies = rows(perRow, 0.02, 0.01, 0);
                for (int turn = 1; turn <= 20; turn++) {
                    for (int k = 0; k < 30; k++) {
                        bodies.setVelocity(k, bodies.vx[k] - 15, bodies.vy[k] - 15);
                    }
                    double energy = Scenes.energy(bodies);
                    TurnLog log = Scenes.turn(advance, bodies);
                    String where = perRow + " a row, turn " + turn + ": ";
                    assertTrue(!log.limited() && log.impacts() <= 500, where + log.impacts() + " impacts");
                    assertTrue(Scenes.energy(bodies) <= energy, where + "energy grew");
                }
            }
        }
    }

    /** Without restitution a rebound is 0, at most any rest speed: nothing is given back, and the heap lies still. */
    @ParameterizedTest
    @EnumSource
    void bodiesWithoutRestitutionRestAlsoAtRestSpeedZero(Arithmetic arithmetic) {
        PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION.withRestSpeed(0), arithmetic, floor(0));
        for (Advance advance : Scenes.both(parts)) {
            Bodies bodies = column(3, -20, 0);
            TurnLog log = Scenes.turn(advance, bodies);
            assertTrue(!log.limited() && log.impacts() <= 5, log.impacts() + " impacts");
            assertEquals(0, Scenes.energy(bodies), 1e-18);
        }
    }

    /** Gases, squeezes and corners without forces: rest takes at most 1e-6 of the energy that a turn begins with. */
    @ParameterizedTest
    @EnumSource
    void restTakesNextToNothingWhereNoForceActs(Arithmetic arithmetic) {
        SplitMix64 random = new SplitMix64(55);
        double taken = 0;
        for (int n = 0; n < 24; n++) {
            double e = n % 4 == 3 ? 0.3 + 0.3 * random.nextDouble()
                : 1 - StrictMath.pow(10, -1 - 3 * random.nextDouble());
            Wall[] walls = n % 3 == 0 ? new Wall[] {floor(1)}
                : Wall.box(n % 3 == 1 ? 400 : 60, n % 3 == 1 ? 400 : 60, 1);
            for (Advance advance : both(arithmetic, walls)) {
                SplitMix64 same = new SplitMix64(n);
                Bodies bodies = n % 3 == 1 ? Scenes.grid(same, 5, 400, 25, 700) : new Bodies(2);
                if (n % 3 == 0) {
                    Scenes.add(bodies, 0, 10 + 5 * same.nextDouble(), 0, 0, 1);
                    Scenes.add(bodies, 0, 60, 0, -50, StrictMath.pow(10, 4 * same.nextDouble()));
                } else if (n % 3 == 2) {
                    Scenes.add(bodies, 30, 30.001, 500, 500, 1);
                }
                Scenes.setRestitution(bodies, e);
                for (int turn = 1; turn <= 20; turn++) {
                    double energy = Scenes.energy(bodies);
                    TurnLog log = Scenes.turn(advance, bodies);
                    double rest = log.restEnergy();
                    taken += rest;
                    String where = n + ", e " + e + ", turn " + turn + ": " + rest + " of " + energy;
                    assertTrue(rest >= -1e-15 * energy && rest <= 1e-6 * energy, where);
                }
            }
        }
        assertTrue(taken > 0, "some have rested");
    }

    /** Thirty that forces press into a corner, in rows of five or one a row: few impacts once they lie still. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.6, 0.9})
    void pilesThatForcesPressIntoACornerComeToRest(double e) {
        Forces forces = new Forces(0, 0, -1, -2);
        for (int perRow : new int[] {1, 5}) {
            PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION, Arithmetic.DOUBLE, floor(e),
                new HalfPlane(0, 0, 1, 0, e)).withForces(forces);
            for (Advance advance : Scenes.both(parts)) {
                Bodies bodies = rows(perRow, 0.5, 0.5, e);
                int still = 0;
                for (int turn = 1; turn <= 600 && still < 20; turn++) {
                    Scenes.accelerate(forces, bodies);
                    TurnLog log = Scenes.turn(advance, bodies);
                    String where = perRow + " a row, e " + e + ", turn " + turn + ": ";
                    assertTrue(!log.limited() && (still == 0 || log.impacts() <= 500), where + log.impacts());
                    still = Scenes.energy(bodies) < 1e-12 ? still + 1 : 0;
                }
                assertEquals(20, still, perRow + " a row, e " + e + ": they still move");
            }
        }
    }
}
