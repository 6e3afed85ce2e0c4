package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;

/** Bodies that forces accelerate: bounces, rest, and what lies on what. Gravity is 2 u per turn^2, y grows upwards. */
class ForcesTest {

    private static final Forces GRAVITY = new Forces(0, 0, 0, -2);

    private static List<Advance> both(ImpactLaw law, Arithmetic arithmetic, Wall... walls) {
        return Scenes.both(Scenes.parts(law, arithmetic, walls).withForces(GRAVITY));
    }

    private static void turn(Advance advance, Bodies bodies, TurnSink sink) {
        Scenes.accelerate(GRAVITY, bodies);
        advance.turn(bodies, sink);
    }

    /** Before it bounces, others of another mass were removed or replaced: all is as if they had never been there. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aBodyKeepsItsForceWhereOthersAreRemovedOrReplaced(boolean replaced) {
        Forces force = new Forces(0, -3, 0, 0);
        Contacts contacts = new Contacts(2).set(1, 1, Contacts.Meaning.ASK);
        PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, contacts, List.of(floor()),
            (time, a, b, all, sink) -> {
                all.remove(Math.max(a, b));
                all.remove(Math.min(a, b));
                for (int k = 0; replaced && k < 2; k++) {
                    Scenes.add(all, 500 + 100 * k, 500, 0, 0, 7);
                }
                return Reaction.Verdict.CHANGED;
            }, false).withForces(force);
        for (Advance advance : Scenes.both(parts)) {
            double[] height = new double[2];
            for (int others = 0; others <= 1; others++) {
                Bodies bodies = new Bodies(3);
                for (int k = 0; k < 2 * others; k++) {
                    bodies.setKind(Scenes.add(bodies, 500 + 24 * k, 500, 40 - 80 * k, 0, 0.01), 1);
                }
                int falling = Scenes.add(bodies, 0, 20, 0, -100, 1);
                force.accelerate(bodies, falling, 0, 0);
                advance.turn(bodies, TurnSink.NONE);
                assertEquals(replaced ? 1 + 2 * others : 1, bodies.size());
                height[others] = bodies.y[0];
            }
            assertEquals(height[0], height[1]);
        }
    }

    private static HalfPlane floor() {
        return new HalfPlane(0, 0, 0, 1, 1);
    }

    /** (v + a/2)^2 / 2 + 2 y at the ends of turns; the height of 100 u is 10 turns of fall from 100 = 2 * 10^2 / 2. */
    @ParameterizedTest
    @EnumSource
    void anElasticBallKeepsItsEnergyAtTheEndsOfTurns(Arithmetic arithmetic) {
        for (Advance advance : both(ImpactLaw.PHYSICS, arithmetic, floor())) {
            Bodies bodies = Scenes.bodies(new double[] {0, 10 + 73.3, 0, 0});
            double energy = 0.5 + 2 * 73.3;
            for (int turn = 0; turn < 500; turn++) {
                turn(advance, bodies, TurnSink.NONE);
                double v = bodies.vy[0] - 1;
                assertEquals(energy, v * v / 2 + 2 * (bodies.y[0] - 10), 1e-10);
            }
        }
    }

    /** One that lies on the floor has one impact a turn, which takes what gravity has given it: its weight. */
    @ParameterizedTest
    @EnumSource
    void aBodyAtRestIsCarriedByItsWeight(Arithmetic arithmetic) {
        for (Advance advance : both(Scenes.WITH_RESTITUTION, arithmetic, floor())) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 10, 0, 0, 3}, {0, 30, 0, 0, 5}});
            bodies.setRestitution(0, 0.9);
            bodies.setRestitution(1, 0.9);
            TurnLog log = new TurnLog();
            for (int turn = 0; turn < 20; turn++) {
                log.clear();
                turn(advance, bodies, log);
                assertEquals(2, log.impacts());
                assertEquals(5 * 2, log.impact(0).impulse(), 1e-9, "the upper one on the lower one");
                assertEquals(8 * 2, log.impact(1).impulse(), 1e-9, "both on the floor");
                assertEquals(30, bodies.y[1], 1e-9);
            }
        }
    }

    /**
     * On a slope of 3-4-5 a body that lies on it is accelerated by 3/5 of gravity, also in the turn in which it comes
     * to rest: it was dropped 1/100 u above, without a bounce.
     */
    @ParameterizedTest
    @EnumSource
    void aBodySlidesDownASlope(Arithmetic arithmetic) {
        for (Advance advance : both(Scenes.WITH_RESTITUTION, arithmetic, new HalfPlane(0, 0, 0.6, 0.8, 1))) {
            Bodies bodies = Scenes.bodies(new double[] {0.6 * 10.01, 0.8 * 10.01, 0, 0});
            bodies.setRestitution(0, 0.5);
            for (int turn = 1; turn <= 20; turn++) {
                turn(advance, bodies, TurnSink.NONE);
                assertEquals(turn * 1.2, 0.8 * bodies.vx[0] - 0.6 * bodies.vy[0], 1e-9);
                assertEquals(0, 0.6 * bodies.vx[0] + 0.8 * bodies.vy[0], 1e-9);
            }
        }
    }

    /** Nothing is lost at the top of a bounce, in a flight, or by bodies that fall together. */
    @ParameterizedTest
    @EnumSource
    void bodiesThatFallTogetherTouchWithoutAnImpact(Arithmetic arithmetic) {
        for (Advance advance : both(Scenes.WITH_RESTITUTION, arithmetic)) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 10, 0, 7}, {0, 30, 0, 7, 4}});
            bodies.setRestitution(0, 0.5);
            TurnLog log = new TurnLog();
            for (int turn = 1; turn <= 10; turn++) {
                turn(advance, bodies, log);
                assertEquals(7 - 2 * turn, bodies.vy[0]);
            }
            assertEquals(0, log.impacts());
        }
    }

    /** Without a force a rebound that would be rest under gravity is none: e u = 0.5. */
    @ParameterizedTest
    @EnumSource
    void slowBodiesBounceWhereNoForceActs(Arithmetic arithmetic) {
        PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION, arithmetic, floor());
        for (Advance advance : Scenes.both(parts)) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 10, 0, -1}, {25, 10, 0, 0}});
            bodies.setRestitution(0, 0.5);
            TurnLog log = Scenes.turn(advance, bodies);
            assertEquals(0.5, bodies.vy[0], 1e-15);
            assertFalse(log.limited());
            assertTrue(log.impacts() == 1);
        }
    }
}
