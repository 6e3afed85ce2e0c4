package steward.lab.oracle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.lab.trial.Rung;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.physics.event.Scenes;

/** Turns of small worlds on every event rung against the oracle: the same impacts in the same order. */
@Execution(ExecutionMode.CONCURRENT)
class EngineAgainstOracleTest {

    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    /** A turn with more impacts is squeezed or chaotic. */
    private static final int MOST = 30;

    static List<Rung> rungs() {
        return Rung.all().stream().filter(Rung::isEvent).toList();
    }

    private static Bodies crowd(SplitMix64 random, double side, double speed) {
        Bodies bodies = new Bodies(6);
        for (int k = 0; k < 6; k++) {
            bodies.add(side * (k % 3) + 20 * random.nextDouble(), side * (k / 3) + 20 * random.nextDouble(), 40,
                random.nextInt(6) == 0 ? Double.POSITIVE_INFINITY : 1 + random.nextInt(4));
            bodies.setVelocity(k, speed * (random.nextDouble() - 0.5), speed * (random.nextDouble() - 0.5));
            bodies.setRestitution(k, 1 - 0.5 * random.nextDouble());
        }
        return bodies;
    }

    /** A chaotic turn magnifies rounding by about the free path over the radius at each impact: 1e-6 leaves room. */
    private static void compare(Rung rung, ImpactLaw law, Bodies bodies, String what, Wall... walls) {
        List<OracleBody> truth = OracleBody.of(bodies);
        Oracle oracle = new Oracle(law.withMaximumImpacts(MOST), List.of(walls));
        List<OracleImpact> impacts = oracle.turn(truth);
        if (oracle.limited()) {
            return;
        }
        TurnLog log = Scenes.turn(rung.advanceOfAnyMass(law, walls), bodies);
        List<String> expected = new ArrayList<>();
        impacts.forEach(impact -> expected.add(impact.a() + " " + impact.b()));
        List<String> found = new ArrayList<>();
        for (int k = 0; k < log.impacts(); k++) {
            found.add(log.impact(k).a() + " " + log.impact(k).b());
        }
        assertEquals(expected, found, what);
        for (int k = 0; k < bodies.size(); k++) {
            OracleBody body = truth.get(k);
            assertEquals(body.x.doubleValue(), bodies.x[k], 1e-6, what);
            assertEquals(body.y.doubleValue(), bodies.y[k], 1e-6, what);
            assertEquals(body.vx.doubleValue(), bodies.vx[k], 1e-6, what);
            assertEquals(body.vy.doubleValue(), bodies.vy[k], 1e-6, what);
        }
    }

    @ParameterizedTest
    @Tag("slow")
    @MethodSource("rungs")
    @Tag("sized")
    void physicsAmongWalls(Rung rung) {
        Wall[] box = Wall.box(320, 240, 0.9);
        Wall[] round = {new Arena(120, 80, 230, 1), new Segment(0, 70, 200, 75, 0.7)};
        for (long seed = 1; seed <= TestSize.of(8, 24); seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = crowd(random, 100, 300);
            for (int k = 0; k < 6; k++) {
                bodies.setPosition(k, bodies.x[k] + 50, bodies.y[k] + 50);
            }
            compare(rung, seed % 2 == 0 ? ImpactLaw.PHYSICS : SOFT, bodies, "box, seed " + seed, box);
            compare(rung, SOFT.withMinimumImpulse(60, true), crowd(random, 100, 200), "round, seed " + seed, round);
        }
    }

    /**
     * Where two are flown to a touch of exactly the radii, rounding decides whether they are pushed apart by 1e-5, so
     * places agree to some 1e-5 and no better; deep overlaps, batches and the minimum are the same.
     */
    @Test
    @Tag("slow")
    @Tag("sized")
    void theOfficialLaw() {
        int[] compared = new int[rungs().size()];
        int turns = TestSize.of(20, 100);
        for (long seed = 1; seed <= turns; seed++) {
            List<OracleBody> truth = OracleBody.of(crowd(new SplitMix64(seed), 75, 100));
            int impacts = new Oracle(ImpactLaw.OFFICIAL_POD_RACE, List.of()).turn(truth).size();
            for (int r = 0; r < compared.length; r++) {
                Bodies bodies = crowd(new SplitMix64(seed), 75, 100);
                TurnLog log = Scenes.turn(rungs().get(r).advanceOfAnyMass(ImpactLaw.OFFICIAL_POD_RACE), bodies);
                boolean same = impacts == log.impacts();
                for (int k = 0; same && k < 6; k++) {
                    same = Math.abs(truth.get(k).x.doubleValue() - bodies.x[k]) < 1e-2
                        && Math.abs(truth.get(k).vy.doubleValue() - bodies.vy[k]) < 1e-2;
                }
                compared[r] += same ? 1 : 0;
            }
        }
        for (int r = 0; r < compared.length; r++) {
            assertTrue(compared[r] >= 0.95 * turns,
                compared[r] + " of " + turns + " turns agree on " + rungs().get(r).name());
        }
    }

    /**
     * A batch of two: when the outer ones meet the heavy one between them, the second is 1.03e-5 u late. The first
     * push takes 1e-5 u of that, so 3e-7 u are left, and no body is pushed a second time.
     */
    @ParameterizedTest
    @MethodSource("rungs")
    void whoReactsInABatchWithoutTouchingIsNotPushed(Rung rung) {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 400, 0, 1, 400}, {1000, 0, 0, 0, 10, 400},
            {2000.0000103, 0, -400, 0, 1, 400}});
        List<OracleBody> truth = OracleBody.of(bodies);
        assertEquals(2, new Oracle(ImpactLaw.OFFICIAL_POD_RACE, List.of()).turn(truth).size());
        TurnLog log = Scenes.turn(rung.advanceOfAnyMass(ImpactLaw.OFFICIAL_POD_RACE), bodies);
        assertEquals(2, log.impacts());
        for (int k = 0; k < 3; k++) {
            assertEquals(truth.get(k).x.doubleValue(), bodies.x[k], 1e-7, "body " + k);
            assertEquals(truth.get(k).vx.doubleValue(), bodies.vx[k], 1e-9, "body " + k);
        }
    }
}
