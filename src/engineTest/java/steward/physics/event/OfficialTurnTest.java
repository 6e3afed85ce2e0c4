package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.event.NaiveOfficialTurn.Hit;
import steward.physics.event.NaiveOfficialTurn.Pod;

/** The official law of the engine against {@link NaiveOfficialTurn}, bit for bit. */
class OfficialTurnTest {

    private static final PhysicsParts OFFICIAL = new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL);
    private static final Motion END = new Motion(true, true, true);

    /** Four pods in a square of so many u, which at 1,600 is a heap of overlapping pods. */
    private static Bodies pods(SplitMix64 random, double side, double speed) {
        Bodies bodies = new Bodies(4);
        for (int k = 0; k < 4; k++) {
            boolean whole = random.nextInt(4) > 0;
            double x = side * random.nextDouble();
            double y = side * random.nextDouble();
            bodies.add(whole ? Math.rint(x) : x, whole ? Math.rint(y) : y, 400, random.nextInt(4) == 0 ? 10 : 1);
            bodies.setVelocity(k, speed * (2 * random.nextDouble() - 1), speed * (2 * random.nextDouble() - 1));
            bodies.setDrag(k, 0.15);
        }
        return bodies;
    }

    private static List<Pod> copy(Bodies bodies) {
        List<Pod> pods = new ArrayList<>();
        for (int k = 0; k < bodies.size(); k++) {
            Pod pod = new Pod();
            pod.x = bodies.x[k];
            pod.y = bodies.y[k];
            pod.vx = bodies.vx[k];
            pod.vy = bodies.vy[k];
            pod.mass = bodies.mass[k];
            pods.add(pod);
        }
        return pods;
    }

    @Test
    void twentyThousandDenseTurnsToTheLastBit() {
        EventAdvance advance = new EventAdvance(OFFICIAL);
        int impacts = 0;
        int batches = 0;
        for (long seed = 1; seed <= 4000; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = pods(random, 1600 + 2400 * random.nextDouble(), 1200);
            for (int turn = 0; turn < 5; turn++) {
                String what = "seed " + seed + " turn " + turn;
                List<Pod> pods = copy(bodies);
                NaiveOfficialTurn naive = new NaiveOfficialTurn(pods);
                List<Hit> hits = naive.advance();
                TurnLog log = Scenes.turn(advance, bodies);
                compareImpacts(hits, log, what);
                comparePods(pods, bodies, what);
                naive.end();
                END.endTurn(bodies);
                comparePods(pods, bodies, what + " end");
                impacts += hits.size();
                for (int k = 1; k < hits.size(); k++) {
                    batches += hits.get(k).time() - hits.get(k - 1).time() <= 1e-5 ? 1 : 0;
                }
            }
        }
        assertTrue(impacts > 20_000 && batches > 1000, impacts + " impacts, " + batches + " of them together");
    }

    private static void compareImpacts(List<Hit> hits, TurnLog log, String what) {
        assertFalse(log.limited(), what);
        assertEquals(hits.size(), log.impacts(), what);
        for (int k = 0; k < hits.size(); k++) {
            Impact impact = log.impact(k);
            assertEquals(hits.get(k), new Hit(impact.time(), impact.a(), impact.b(), impact.impulse()), what);
        }
    }

    private static void comparePods(List<Pod> pods, Bodies bodies, String what) {
        for (int k = 0; k < pods.size(); k++) {
            Pod pod = pods.get(k);
            assertEquals(pod.x, bodies.x[k], what);
            assertEquals(pod.y, bodies.y[k], what);
            assertEquals(pod.vx, bodies.vx[k], what);
            assertEquals(pod.vy, bodies.vy[k], what);
        }
    }

    /** Pods heaped in the space of one: the minimum impulse drives them apart in a bounded number of impacts. */
    @Test
    void heapsOfPodsNeverHang() {
        EventAdvance advance = new EventAdvance(OFFICIAL);
        int most = 0;
        for (long seed = 1; seed <= 2000; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = pods(random, 200 + 1000 * random.nextDouble(), seed % 2 == 0 ? 0 : 3000);
            for (int turn = 0; turn < 3; turn++) {
                TurnLog log = Scenes.turn(advance, bodies);
                END.endTurn(bodies);
                assertFalse(log.limited(), "seed " + seed);
                assertTrue(Scenes.allFinite(bodies), "seed " + seed);
                most = Math.max(most, log.impacts());
            }
        }
        assertTrue(most > 20, "at most " + most + " impacts a turn: not a heap");
    }

    /** By hand: 900 apart, 400 u per turn toward each other: 100 u of room, t = 1/4; f = 200, J = 400, speeds swap. */
    @Test
    void twoPodsByHand() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 200, 0, 1, 400}, {900, 0, -200, 0, 1, 400}});
        TurnLog log = Scenes.turn(new EventAdvance(OFFICIAL), bodies);
        assertEquals(1, log.impacts());
        assertEquals(0.25, log.impact(0).time());
        assertEquals(400, log.impact(0).impulse());
        assertEquals(1, log.impact(0).a(), "the first of the pair is the higher");
        assertEquals(-200, bodies.vx[0]);
        assertEquals(50 - 1e-5 - 150, bodies.x[0], 1e-12, "pushed out by 1e-5");
    }

    /** Touching pods that separate react all the same: f = -50, J = -50 + 120. */
    @Test
    void touchingPodsThatSeparateReact() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, -50, 0, 1, 400}, {790, 0, 50, 0, 1, 400}});
        TurnLog log = Scenes.turn(new EventAdvance(OFFICIAL), bodies);
        assertEquals(1, log.impacts());
        assertEquals(0, log.impact(0).time());
        assertEquals(70, log.impact(0).impulse());
        assertEquals(-120, bodies.vx[0]);
    }

    /** Each body has its own drag; parts that are not named do nothing. */
    @Test
    void onlyNamedPartsOfTheEndOfATurnHappen() {
        Bodies bodies = Scenes.bodies(new double[][] {{1.25, 2.75, 100.5, -40}, {1.25, 2.75, 100.5, -40}});
        bodies.setDrag(1, 0.25);
        new Motion(false, false, false).endTurn(bodies);
        assertEquals(100.5, bodies.vx[1]);
        new Motion(true, false, false).endTurn(bodies);
        assertEquals(100.5, bodies.vx[0]);
        assertEquals(75.375, bodies.vx[1]);
        assertEquals(-30, bodies.vy[1]);
        assertEquals(1.25, bodies.x[1]);
    }
}
