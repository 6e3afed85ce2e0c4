package steward.lab.oracle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.Scenes;
import steward.physics.event.StepAdvance;

/** The true turn of the oracle, the error of a rung against it, and the pairs that the oracle may skip. */
@Execution(ExecutionMode.CONCURRENT)
class TurnTruthTest {

    private static PhysicsParts parts(Arithmetic arithmetic, Wall... walls) {
        return new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, new Contacts(1), List.of(walls), null, false);
    }

    /** Two of radius 10, 100 u apart, one of which flies at the other; it stops there, and the other flies on. */
    private static Bodies headOn(double speed) {
        return Scenes.bodies(new double[][] {{0, 0, speed, 0}, {100, 0, 0, 0}});
    }

    /** A turn from impact to impact. */
    private static Bodies flown(PhysicsParts parts, Bodies start) {
        Bodies flown = start.copy();
        new EventAdvance(parts).turn(flown, TurnSink.NONE);
        return flown;
    }

    /** The truth has so many impacts, and the engine comes where it does. @return where that is */
    private static Bodies assertAgree(int impacts, PhysicsParts parts, Bodies start) {
        TurnTruth truth = TurnTruth.of(start, parts);
        Bodies flown = flown(parts, start);
        assertEquals(impacts, truth.impacts());
        assertEquals(0, truth.positionError(flown), 1e-9);
        return flown;
    }

    private static TurnError errorOfSteps(Bodies start, int steps, Wall... walls) {
        TurnTruth truth = TurnTruth.of(start, parts(Arithmetic.DOUBLE, walls));
        Bodies after = start.copy();
        TurnLog log = Scenes.turn(new StepAdvance(parts(Arithmetic.DOUBLE, walls), steps), after);
        return truth.error(after, log);
    }

    /**
     * One step of 200 u jumps over the other body: the impact at 80 u is missed. In truth body 0 stays at 80 and body
     * 1 flies to 220; found are 200 and 100, each 120 off.
     */
    @Test
    void anImpactThatIsTunnelledThroughIsMissed() {
        assertEquals(new TurnError(120, 1, 0, 0), errorOfSteps(headOn(200), 1));
    }

    /** Four steps of 45 u: an overlap at 90 u; the impact is there, only late. */
    @Test
    void anImpactThatComesLateIsNotMissed() {
        TurnError error = errorOfSteps(headOn(180), 4);
        assertEquals(0, error.missed());
        assertEquals(0, error.invented());
        assertTrue(error.position() > 1, error.toString());
    }

    /** Body 0 flies through the second, which is missed, into a third, which it would never have come to. */
    @Test
    void anImpactThatNeverWasIsInvented() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 190, 0}, {100, 0, 0, 0}, {200, 0, 0, 0}});
        TurnError error = errorOfSteps(bodies, 1);
        assertEquals(2, error.missed(), "0 with 1 and 1 with 2");
        assertEquals(1, error.invented(), "0 with 2");
    }

    @Test
    void wallsAreMissedToo() {
        Bodies bodies = Scenes.bodies(new double[] {50, 50, 30, 0});
        Wall wall = new HalfPlane(100, 0, -1, 0, 1);
        TurnTruth truth = TurnTruth.of(bodies, parts(Arithmetic.DOUBLE));
        TurnLog log = new TurnLog();
        bodies.setVelocity(0, 60, 0);
        new EventAdvance(parts(Arithmetic.DOUBLE, wall)).turn(bodies, log);
        assertEquals(1, truth.error(bodies, log).invented());
        assertEquals(3, truth.error(bodies, log).energy(), "four times the energy instead of once");
    }

    @Test
    void theExactRungIsOffByRoundingOnly() {
        long seed = 7;
        SplitMix64 random = new SplitMix64(seed);
        double steps = 0;
        for (int n = 0; n < 50; n++) {
            Bodies start = new Bodies(6);
            for (int k = 0; k < 6; k++) {
                start.add(50 + 110 * (k % 3) + 20 * random.nextDouble(), 50 + 110 * (k / 3) + 20 * random.nextDouble(),
                    40, 1);
                start.setVelocity(k, 80 * (random.nextDouble() - 0.5), 80 * (random.nextDouble() - 0.5));
            }
            PhysicsParts parts = parts(Arithmetic.EXACT, Wall.box(400, 400, 1));
            TurnTruth truth = TurnTruth.of(start, parts);
            Bodies after = start.copy();
            TurnLog log = Scenes.turn(new EventAdvance(parts), after);
            TurnError error = truth.error(after, log);
            assertEquals(log.impacts(), truth.impacts());
            assertTrue(error.position() < 1e-11 && error.energy() < 1e-14, "seed " + seed + ": " + error);
            assertEquals(0, error.missed() + error.invented(), "seed " + seed);
            steps += errorOfSteps(start, 4, Wall.box(400, 400, 1)).position();
        }
        assertTrue(steps / 50 > 1e-3, "steps are off by " + steps / 50 + " on average");
    }

    @Test
    void whatIsNoNumberIsInfinitelyOff() {
        Bodies start = headOn(200);
        TurnTruth truth = TurnTruth.of(start, parts(Arithmetic.DOUBLE));
        start.x[1] = Double.NaN;
        assertEquals(Double.POSITIVE_INFINITY, truth.positionError(start));
    }

    /** floor(x + 1/2), and 0.75 of the speed cut toward zero: 149.25 is 149, 37.5 is 38, -2.5 is -2. */
    @Test
    void finalNumbersAreRoundedByHand() {
        Motion motion = new Motion(true, true, true);
        Bodies start = Scenes.bodies(new double[][] {{30, -3.5, 7.5, 1}, {200, 0, 199, -1}});
        start.setDrag(0, 0.25);
        start.setDrag(1, 0.25);
        TurnTruth truth = TurnTruth.of(start, parts(Arithmetic.DOUBLE));
        Bodies ended = start.copy();
        ended.setPosition(0, 38, -2);
        ended.setVelocity(0, 5, 0);
        ended.setPosition(1, 399, -1);
        ended.setVelocity(1, 149, 0);
        assertEquals(0, truth.differing(start, ended, motion));
        ended.setVelocity(1, 150, 0);
        assertEquals(1, truth.differing(start, ended, motion));
    }

    @Test
    void bodiesThatIgnoreEachOtherFlyThrough() {
        PhysicsParts deaf = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE,
            new Contacts(1).set(0, 0, Contacts.Meaning.NONE), List.of(), null, false);
        assertAgree(0, deaf, headOn(200));
    }

    /** The reaction takes one of the two away at their touch: who does not do so is infinitely wrong. */
    @Test
    void aReactionChangesTheTruthToo() {
        PhysicsParts eating = asking((time, a, b, bodies, sink) -> {
            bodies.remove(b);
            return Reaction.Verdict.CHANGED;
        });
        Bodies start = headOn(200);
        TurnTruth truth = TurnTruth.of(start, eating);
        Bodies one = flown(eating, start);
        Bodies both = flown(parts(Arithmetic.DOUBLE), start);

        assertEquals(1, one.size());
        assertEquals(0, truth.positionError(one), 1e-9);
        assertEquals(Double.POSITIVE_INFINITY, truth.positionError(both));
        assertEquals(2, truth.differing(start, both, new Motion(true, true, true)));
    }

    @Test
    void aReactionThatBouncesIsAnImpactOfTheTruth() {
        assertAgree(1, asking((time, a, b, bodies, sink) -> Reaction.Verdict.BOUNCE), headOn(200));
    }

    /** Body 0 flies through the other and comes to 200; the reaction is asked once. */
    @Test
    void bodiesPassThroughEachOtherInTruthToo() {
        int[] asked = new int[1];
        PhysicsParts passing = asking((time, a, b, bodies, sink) -> {
            asked[0]++;
            return Reaction.Verdict.PASS;
        });
        assertEquals(200, assertAgree(0, passing, headOn(200)).x[0], 1e-9);
        assertEquals(2, asked[0], "in truth and in the engine");
    }

    /** Taken at a distance of 50 instead of 20: at 50 u of the way, after a quarter of the turn. */
    @Test
    void aContactAtADistanceOfItsOwnIsMetInTruthToo() {
        double[] when = new double[1];
        PhysicsParts reaching = reaching((time, a, b, bodies, sink) -> {
            when[0] = time;
            bodies.remove(b);
            return Reaction.Verdict.CHANGED;
        });
        TurnTruth.of(headOn(200), reaching);
        assertEquals(0.25, when[0], 1e-12);
        assertAgree(0, reaching, headOn(200));
    }

    /** A third body stands behind them: the two pass each other once, and the one that has passed bounces off it. */
    @Test
    void bodiesThatPassEachOtherDoSoUntilTheyAreApart() {
        PhysicsParts passing = asking((time, a, b, bodies, sink) ->
            bodies.id(a) + bodies.id(b) == 1 ? Reaction.Verdict.PASS : Reaction.Verdict.BOUNCE);
        Bodies start = Scenes.bodies(new double[][] {{0, 0, 100, 0, 1, 5}, {20, 0, 0, 0, 1, 5}, {60, 0, 0, 0, 1, 5}});
        assertEquals(50, assertAgree(1, passing, start).x[0], 1e-9);
    }

    /** The reaction is told of impacts at walls too: here it takes the speed away. */
    @Test
    void aReactionIsToldOfImpactsAtWalls() {
        PhysicsParts stopping = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE,
            new Contacts(1).setWall(0, Contacts.Meaning.ASK), List.of(new HalfPlane(0, 0, 0, 1, 1)), new Reaction() {

                @Override
                public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
                    return Verdict.BOUNCE;
                }

                @Override
                public boolean after(double time, int a, int b, Bodies bodies, TurnSink sink) {
                    bodies.setVelocity(a, 0, 0);
                    return false;
                }
            }, false);
        Bodies falling = Scenes.bodies(new double[][] {{0, 10, 0, -20, 1, 5}});
        assertEquals(5, assertAgree(1, stopping, falling).y[0], 1e-9);
    }

    @Test
    void whatTheOracleCannotDoIsRefused() {
        PhysicsParts bouncing = reaching((time, a, b, bodies, sink) -> Reaction.Verdict.BOUNCE);
        assertThrows(IllegalArgumentException.class, () -> TurnTruth.of(headOn(200), bouncing));
    }

    private static PhysicsParts reaching(Reaction reaction) {
        return new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, new Contacts(1).askWithin(0, 0, 50), List.of(),
            reaction, false);
    }

    private static PhysicsParts asking(Reaction reaction) {
        return new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE,
            new Contacts(1).set(0, 0, Contacts.Meaning.ASK), List.of(), reaction, false);
    }

    /** A disc along the rim of an arena, where another comes to it: the oracle does not slide, exact is the truth. */
    @Test
    void whereABodySlidesExactIsTheTruth() {
        Bodies start = Scenes.bodies(new double[][] {{0, 90, 0, 0}, {35, 70, 0, 0}});
        Scenes.setRestitution(start, 0.5);
        start.setVelocity(0, 50, 0);
        PhysicsParts soft = new PhysicsParts(ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM),
            Arithmetic.EXACT, new Contacts(1), List.of(new Arena(0, 0, 100, 1)), null, false);
        TurnTruth truth = TurnTruth.of(start, soft);
        Bodies after = start.copy();
        TurnLog log = Scenes.turn(new EventAdvance(soft), after);
        assertEquals(new TurnError(0, 0, 0, 0), truth.error(after, log));
        assertFalse(truth.limited());
        assertTrue(truth.impacts() > 0, "found " + truth.impacts());
    }

    /** A pair that meets in time is never skipped, by however little; most pairs that are far apart are. */
    @Test
    void theOracleSparesOnlyWhoCannotMeet() {
        long seed = 11;
        SplitMix64 random = new SplitMix64(seed);
        int spared = 0;
        int met = 0;
        for (int n = 0; n < 6_000; n++) {
            double size = StrictMath.pow(10, random.nextInt(-8, 8));
            Bodies pair = new Bodies(2);
            pair.add(size * random.nextDouble(), size * random.nextDouble(), size * 0.05, 1);
            pair.add(size * random.nextDouble(), size * random.nextDouble(), size * 0.05, 1);
            pair.setVelocity(0, size * (random.nextDouble() - 0.5), size * (random.nextDouble() - 0.5));
            pair.setVelocity(1, size * (random.nextDouble() - 0.5), size * (random.nextDouble() - 0.5));
            List<OracleBody> bodies = OracleBody.of(pair);
            OracleBody p = bodies.get(0);
            OracleBody q = bodies.get(1);
            java.math.BigDecimal until = OracleTimeOfImpact.circle(p.x.subtract(q.x), p.y.subtract(q.y),
                p.vx.subtract(q.vx), p.vy.subtract(q.vy), p.radius.add(q.radius));
            OracleBroadPhase reach = new OracleBroadPhase(bodies);
            if (until != null) {
                met++;
                assertTrue(reach.earliest(0, 1, Double.NaN, false) <= until.doubleValue(),
                    "seed " + seed + ", pair " + n);
                Wall wall = new HalfPlane(q.x.doubleValue(), 0, p.x.compareTo(q.x) > 0 ? 1 : -1, 0, 1);
                java.math.BigDecimal wallTime = OracleTimeOfImpact.wall(p, wall);
                assertFalse(wallTime != null && reach.earliest(0, wall) > wallTime.doubleValue(), "seed " + seed);
            }
            spared += reach.earliest(0, 1, Double.NaN, false) > 0.1 ? 1 : 0;
        }
        assertTrue(spared > 3_000 && met > 300, "spared " + spared + ", met " + met);
    }
}
