package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.scene.Accuracy;

/** The common loop of official games, filled in with the pod race's expressions, has the engine's own bits. */
@Execution(ExecutionMode.CONCURRENT)
class OfficialLoopTest {

    private static final PhysicsParts PARTS = new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL);
    private static final int TURNS = 100_000;

    @Test
    @Tag("sized")
    void thePodRaceIsTheSameInIt() {
        int turns = TestSize.of(TURNS / 10, TURNS);
        SplitMix64 random = new SplitMix64(16);
        Advance loop = new PodRaceLoop();
        Advance expected = new EventAdvance(PARTS);
        Bodies bodies = new Bodies(6);
        long impacts = 0;
        for (int turn = 0; turn < turns; turn++) {
            fill(bodies, random, 2 + turn % 5);
            impacts += Scenes.assertSameTurn(expected, loop, bodies, "seed 16, turn " + turn);
        }
        assertTrue(impacts > turns, impacts + " impacts");
    }

    /** Crowded: most pairs have an impact, many of them several together. */
    private static void fill(Bodies bodies, SplitMix64 random, int count) {
        while (bodies.size() > 0) {
            bodies.remove(bodies.size() - 1);
        }
        for (int k = 0; k < count; k++) {
            int body = bodies.add(random.nextInt(0, 2500), random.nextInt(0, 2500), 400, random.nextInt(5) == 0 ? 10
                : 1);
            bodies.setVelocity(body, random.nextInt(-800, 800), random.nextInt(-800, 800));
        }
        if (random.nextInt(4) == 0 && count > 3) {    // a mirror image, so that two impacts are at the same time
            for (int k = 0; k < 2; k++) {
                bodies.setPosition(k + 2, 5000 - bodies.x[k], bodies.y[k]);
                bodies.setVelocity(k + 2, -bodies.vx[k], bodies.vy[k]);
                bodies.setMass(k + 2, bodies.mass[k]);
            }
        }
    }

    /** Without a push-out two that touch would react for ever: both loops end at the bound, and in the same state. */
    @Test
    void itEndsAtTheBoundOnImpacts() {
        ImpactLaw law = ImpactLaw.OFFICIAL_POD_RACE.withMaximumImpacts(7);
        PhysicsParts parts = new PhysicsParts(law, Arithmetic.OFFICIAL);
        Advance stuck = new OfficialLoop(parts, false) {
            @Override
            protected void look(Bodies bodies, double now) {
                offer(0, 0, bodies.id(0), bodies.id(1));
            }

            @Override
            protected boolean isInTurn(double now, double time) {
                return true;
            }

            @Override
            protected double fly(Bodies bodies, double now, double time) {
                return now;
            }

            @Override
            protected void react(Bodies bodies, double now, double time, int kind, int a, int b, TurnSink sink) {
                sink.knot(a, now, 0, 0);
            }
        };
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 10, 0, 1, 400}, {700, 0, 0, 0, 1, 400},
            {9000, 0, 5, 0, 1, 400}});
        TurnLog log = Scenes.turn(stuck, bodies);

        assertTrue(log.limited());
        assertEquals(7, log.knots() - 2, "seven reactions, and a knot of each of the two that stop");
        assertArrayEquals(new int[] {0, 1}, log.limitBodies());
        assertEquals(List.of(0.0, 10.0, 9005.0), List.of(bodies.x[0], bodies.vx[0], bodies.x[2]));
    }

    @Test
    void numbersOutOfRangeAreLeftToTheExactArithmetic() {
        Bodies bodies = Scenes.bodies(new double[][] {{1e155, 0, -1e160, 0, 1, 400}, {0, 0, 0, 0, 1, 400}});
        Scenes.assertSameTurn(new EventAdvance(PARTS), new PodRaceLoop(), bodies, "huge");
    }

    /** A game's own expressions are for the rung event/official alone, with any number of bodies. */
    @Test
    void onlyTheOfficialRungUsesThem() {
        Advance own = new PodRaceLoop();
        for (Accuracy rung : Accuracy.ladder()) {
            PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, rung.arithmetic(), new Contacts(1), List.of(),
                null, false, of -> own, Forces.NONE);
            boolean official = rung.equals(Accuracy.event(Arithmetic.OFFICIAL));
            for (int bodies : new int[] {0, 4, 100}) {
                assertEquals(official, rung.advance(parts, bodies) == own, rung.text());
            }
            if (official) {
                assertSame(own, rung.advance(parts));
            }
        }
    }
}
