package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.match.Refusal;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.HalfPlane;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.Reaction.Verdict;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;

/** Turns in fixed steps: what they see, what they cannot see, and that they end. */
class StepAdvanceTest {

    private static StepAdvance steps(int count, Wall... walls) {
        return new StepAdvance(Scenes.parts(Scenes.WITH_RESTITUTION, Arithmetic.DOUBLE, walls), count);
    }

    /**
     * <pre>
     *     O------------------>  o              400 u in the turn, through a body of 20 u at 200
     * </pre>
     */
    @Test
    void aFastBodyTunnelsUnlessAStepEndsInTheOverlap() {
        for (int k : new int[] {1, 2, 4, 8, 16}) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 400, 0}, {210, 0, 0, 0}});
            TurnLog log = Scenes.turn(steps(k), bodies);
            assertEquals(k == 1 ? 0 : 1, log.impacts(), k + " steps");
            assertEquals(k == 1 ? 400 : 0, bodies.vx[0], k + " steps");
        }
    }

    /** At 100 u per turn the touch is at t = 0.25 and the centres pass at 0.45: three steps are enough to see it. */
    @Test
    void anImpactIsLateByLessThanAStepAndPushesOutOfTheOverlap() {
        for (int k = 3; k <= StepAdvance.MOST_STEPS; k++) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 100, 0}, {45, 0, 0, 0, 3}});
            TurnLog log = Scenes.turn(steps(k), bodies);
            assertEquals(1, log.impacts(), k + " steps");
            double time = log.impact(0).time();
            assertTrue(time >= 0.25 && time < 0.25 + 1.0 / k + 1e-12, k + " steps: " + time);
            assertEquals(-50, bodies.vx[0], 1e-12);
            assertEquals(50, bodies.vx[1], 1e-12);
            assertTrue(Scenes.deepestOverlap(bodies) <= 1e-9, k + " steps");
            int last = log.knots() - 1;
            double flown = 1 - log.knotTime(last);
            assertEquals(log.knotX(last) + 50 * flown, bodies.x[1], 1e-9, "the path shows the push-out");
        }
    }

    /** One oblique impact and one at a wall: the error after the turn shrinks with the steps, at least as 8 u / k. */
    @Test
    void moreStepsComeNearerToTheEvents() {
        Wall wall = new HalfPlane(0, 0, 0, 1, 1);
        double[] error = new double[11];
        for (long seed = 1; seed <= 200; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double aim = 10 * (random.nextDouble() - 0.5);
            Bodies start = new Bodies(2);
            Scenes.add(start, 0, 60 + 20 * random.nextDouble(), 40 + 20 * random.nextDouble(), -70, 1);
            Scenes.add(start, 60, 40 + aim, -10 * random.nextDouble(), 0, 2);
            Bodies exact = start.copy();
            Scenes.advance(ImpactLaw.PHYSICS, wall).turn(exact, TurnSink.NONE);
            for (int p = 0; p <= 10; p++) {
                Bodies stepped = start.copy();
                steps(1 << p, wall).turn(stepped, TurnSink.NONE);
                error[p] += Math.hypot(stepped.x[0] - exact.x[0], stepped.y[0] - exact.y[0]) / 200;
            }
        }
        assertTrue(error[0] > 5, "one step is far off: " + error[0]);
        assertTrue(error[10] < error[5] / 8 && error[5] < error[0] / 4, java.util.Arrays.toString(error));
        assertTrue(error[10] < 0.2, java.util.Arrays.toString(error));
    }

    /** Momentum of impulses is balanced, energy of elastic ones stays: the push-out moves places, no speeds. */
    @Test
    void impulsesKeepTheBooks() {
        Wall[] walls = Wall.box(1000, 1000, 1);
        int impacts = 0;
        for (int k : new int[] {1, 3, 8, 64}) {
            Bodies bodies = Scenes.grid(new SplitMix64(k), 4, 1000, 80, 300);
            StepAdvance advance = steps(k, walls);
            double energy = Scenes.energy(bodies);
            for (int turn = 0; turn < 50; turn++) {
                TurnLog log = Scenes.turn(advance, bodies);
                impacts += log.impacts();
                for (int i = 0; i < log.impacts(); i++) {
                    Impact impact = log.impact(i);
                    assertEquals(0, impact.momentumAx() + impact.momentumBx(), 1e-9, k + " steps");
                    assertEquals(0, impact.momentumAy() + impact.momentumBy(), 1e-9, k + " steps");
                    assertTrue(impact.impulse() >= 0, "nobody is pulled back");
                }
                assertEquals(energy, Scenes.energy(bodies), 1e-11 * energy, k + " steps, turn " + turn);
                assertTrue(Scenes.allFinite(bodies));
            }
            for (int body = 0; body < bodies.size(); body++) {
                assertTrue(bodies.x[body] > -400 && bodies.x[body] < 1400, "nobody has left");
            }
        }
        assertTrue(impacts > 500, impacts + " impacts");
    }

    /** A heap of 16 bodies in the space of two, every law: at most one impact per pair and step. */
    @Test
    void theWorstTurnIsBounded() {
        for (ImpactLaw law : List.of(ImpactLaw.PHYSICS, Scenes.WITH_RESTITUTION, ImpactLaw.OFFICIAL_POD_RACE)) {
            Bodies bodies = new Bodies(16);
            for (int k = 0; k < 16; k++) {
                Scenes.add(bodies, k % 4, k / 4, 10 * (k % 3 - 1), 7 * (k % 5 - 2), 1 + k);
                bodies.setRestitution(k, 0.05);
            }
            bodies.setMass(5, Double.POSITIVE_INFINITY);
            StepAdvance advance = new StepAdvance(Scenes.parts(law, Arithmetic.DOUBLE), 8);
            TurnLog log = Scenes.turn(advance, bodies);
            assertTrue(log.impacts() > 20 && log.impacts() <= 8 * 120, log.impacts() + " impacts");
            assertFalse(log.limited());
            assertTrue(Scenes.allFinite(bodies));
        }
    }

    private static StepAdvance asking(int count, Reaction reaction) {
        return new StepAdvance(new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE,
            new Contacts(2).set(0, 1, Meaning.ASK), List.of(), reaction, false), count);
    }

    @Test
    void contactsAskOnceAndThoseWhoPassAreLeftAlone() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 100, 0}, {50, 0, 0, 0}});
        bodies.setKind(1, 1);
        List<Double> asked = new ArrayList<>();
        StepAdvance advance = asking(8, (time, a, b, all, sink) -> {
            asked.add(time);
            return Verdict.PASS;
        });
        advance.turn(bodies, TurnSink.NONE);
        assertEquals(List.of(0.375), asked, "overlap from t = 0.3 to 0.7: first seen after three eighths");
        assertEquals(100, bodies.x[0]);
        assertTrue(bodies.passing().isEmpty());
    }

    /** The first takes three away at one touch: after each the step looks anew; saying so without end ends. */
    @Test
    void afterAChangeTheStepLooksAnewButNotForEver() {
        Bodies bodies = new Bodies(5);
        Scenes.add(bodies, 0, 0, 100, 0, 1);
        for (int k = 0; k < 3; k++) {
            Scenes.add(bodies, 105 + k, k, 0, 0, 1);
            bodies.setKind(k + 1, 1);
        }
        asking(1, (time, a, b, all, sink) -> {
            all.remove(b);
            return Verdict.CHANGED;
        }).turn(bodies, TurnSink.NONE);
        assertEquals(1, bodies.size());
        Scenes.add(bodies, 205, 0, 0, 0, 1);
        bodies.setKind(1, 1);
        int[] asked = new int[1];
        asking(1, (time, a, b, all, sink) -> {
            asked[0]++;
            return Verdict.CHANGED;
        }).turn(bodies, TurnSink.NONE);
        assertEquals(1 + 2, asked[0], "once, and once more per body");
    }

    @Test
    void theNumberOfStepsHasARange() {
        for (int count : new int[] {0, -1, 1025}) {
            Refusal.refused(count + " steps, expected 1..1024", () -> steps(count));
        }
    }
}
