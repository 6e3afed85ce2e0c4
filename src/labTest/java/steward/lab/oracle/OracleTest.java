package steward.lab.oracle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.Scenes;

/** The oracle itself, against closed forms by hand, conservation, reversal and the digits of pi. */
@Execution(ExecutionMode.CONCURRENT)
class OracleTest {

    /** Bound on an error that 64 digits leave after a few operations. */
    private static final BigDecimal TINY = new BigDecimal("1e-55");
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    private static void assertNear(String expected, BigDecimal found) {
        assertNear(new BigDecimal(expected), found);
    }

    private static void assertNear(BigDecimal expected, BigDecimal found) {
        assertTrue(expected.subtract(found).abs().compareTo(TINY) < 0, () -> "expected " + expected + " got " + found);
    }

    private static Bodies one(double x, double y, double radius, double vx, double vy) {
        return Scenes.bodies(new double[][] {{x, y, vx, vy, 1, radius}});
    }

    private static List<OracleImpact> turn(ImpactLaw law, List<OracleBody> bodies, Wall... walls) {
        return new Oracle(law, List.of(walls)).turn(bodies);
    }

    /** sqrt 2 to 60 digits, as published. */
    @Test
    void theRootOfTwo() {
        assertNear("1.41421356237309504880168872420969807856967187537694807317667974",
            Decimals.root(new BigDecimal(2)));
        assertNear("1e-155", Decimals.root(new BigDecimal("1e-310")));
        assertEquals(0, new BigDecimal("1e160").compareTo(Decimals.root(new BigDecimal("1e320"))));
    }

    /**
     * Radius 1 each, offset 1 across, 10 apart along, closing at 16: the centres touch when the gap along is sqrt 3:
     * t = (10 - sqrt 3) / 16.
     */
    @Test
    void anOffCentreTouchByHand() {
        List<OracleBody> state = OracleBody.of(
            Scenes.bodies(new double[][] {{0, 0, 16, 0, 1, 1}, {10, 1, 0, 0, 1, 1}}));
        OracleImpact impact = turn(ImpactLaw.PHYSICS, state).get(0);
        BigDecimal three = Decimals.root(new BigDecimal(3));
        assertNear(BigDecimal.TEN.subtract(three).divide(new BigDecimal(16), Decimals.ROUND), impact.time());
        // n = (sqrt 3, 1) / 2; b gets 16 n (n.x) = (12, 4 sqrt 3) and a keeps the rest
        assertNear("12", impact.vbx());
        assertNear(three.multiply(new BigDecimal(4)), impact.vby());
        assertNear("4", impact.vax());
        assertNear(three.multiply(new BigDecimal(-4)), impact.vay());
        assertNear(three.multiply(new BigDecimal(8)), impact.impulse());
    }

    /** Masses 1 and 3, head-on at 6: with e = 1/2 the approach of 6 comes back as 3 around the mean of 3/2. */
    @Test
    void restitutionByHand() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 6, 0, 1, 1}, {4, 0, 0, 0, 3, 1}});
        bodies.setRestitution(1, 0.5);
        List<OracleBody> state = OracleBody.of(bodies);
        assertEquals(1, turn(SOFT, state).size());
        assertNear("-0.75", state.get(0).vx);
        assertNear("2.25", state.get(1).vx);
    }

    /** 900 apart, 400 u per turn toward each other: at t = 1/4 they touch, f = 200, J = 400, pushed 1e-5. */
    @Test
    void twoOfficialPodsByHand() {
        List<OracleBody> state = OracleBody.of(
            Scenes.bodies(new double[][] {{0, 0, 200, 0, 1, 400}, {900, 0, -200, 0, 1, 400}}));
        List<OracleImpact> impacts = turn(ImpactLaw.OFFICIAL_POD_RACE, state);
        assertEquals(1, impacts.size());
        assertEquals(1, impacts.get(0).a(), "pairs are looked at from the last body down");
        assertNear("0.25", impacts.get(0).time());
        assertNear("400", impacts.get(0).impulse());
        assertNear(new BigDecimal("-100").subtract(Decimals.of(1e-5)), state.get(0).x);
        assertNear("-200", state.get(0).vx);
    }

    /**
     * At rest and overlapping by 10: they react although they do not approach, f = 0, J = 120; 5 and 1e-5 of push each.
     */
    @Test
    void restingPodsThatOverlapReactUnderTheOfficialLawOnly() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 0, 0, 1, 400},
            {790, 0, 0, 0, Double.POSITIVE_INFINITY, 400}});
        List<OracleBody> state = OracleBody.of(bodies);
        assertEquals(1, turn(ImpactLaw.OFFICIAL_POD_RACE, state).size());
        assertNear("-120", state.get(0).vx);
        assertNear(new BigDecimal(-130).subtract(Decimals.of(1e-5).multiply(new BigDecimal(2))), state.get(0).x);
        assertEquals(0, turn(ImpactLaw.PHYSICS, OracleBody.of(bodies)).size());
    }

    /** Pairs that touch within 1e-5 turns of the first react together, on the speeds as the first left them. */
    @Test
    void aBatchReactsTogether() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 400, 0, 1, 400}, {1000, 0, 0, 0, 1, 400},
            {2000.001, 0, -400, 0, 1, 400}});
        List<OracleImpact> batch = turn(ImpactLaw.OFFICIAL_POD_RACE, OracleBody.of(bodies));
        assertEquals(1, batch.get(0).a());
        assertEquals(2, batch.get(1).a());
        assertTrue(batch.get(1).time().compareTo(batch.get(0).time()) > 0);
        assertNear(batch.get(0).ax().add(Decimals.of(1e-5)), batch.get(1).bx());
    }

    @Test
    void wallsByHand() {
        // a half-plane 3-4-5: gap 10, closing 5
        List<OracleBody> plane = OracleBody.of(one(0, 0, 5, 40, 30));
        HalfPlane wall = new HalfPlane(30, 25, -0.8, -0.6, 1);
        OracleImpact impact = turn(ImpactLaw.PHYSICS, plane, wall).get(0);
        assertTrue(impact.time().subtract(new BigDecimal("0.68")).abs().doubleValue() < 1e-16, "0.8 is no double");
        // an arena of 100 around the origin, body of 10 from the centre: t = 90 / 180
        List<OracleBody> round = OracleBody.of(one(0, 0, 10, 108, 144));
        assertNear("0.5", turn(ImpactLaw.PHYSICS, round, new Arena(0, 0, 100, 1)).get(0).time());
        assertNear("0", round.get(0).x);
        assertNear("0", round.get(0).y);
        // the flat of a segment, and its end: centre 3 beyond it, radius 5, so 4 above
        Segment segment = new Segment(0, 0, 10, 0, 1);
        assertNear("0.75", turn(ImpactLaw.PHYSICS, OracleBody.of(one(5, 20, 5, 0, -20)), segment).get(0).time());
        List<OracleBody> end = OracleBody.of(one(13, 20, 5, 0, -20));
        assertNear("0.8", turn(ImpactLaw.PHYSICS, end, segment).get(0).time());
        // n = (-3, -4) / 5, approach 16: v = (0, -20) + 2 * 16 * (3, 4) / 5
        assertNear("19.2", end.get(0).vx);
        assertNear("5.6", end.get(0).vy);
        assertEquals(0, turn(ImpactLaw.PHYSICS, OracleBody.of(one(15, 20, 5, 0, -40)), segment).size(), "tangent");
    }

    @Test
    void aTangentIsAMissAndAHairLessIsAHit() {
        BigDecimal two = new BigDecimal(2);
        BigDecimal v = new BigDecimal(-1);
        assertNull(OracleTimeOfImpact.circle(BigDecimal.TEN, two, v, BigDecimal.ZERO, two));
        BigDecimal less = two.subtract(new BigDecimal("1e-300"));
        BigDecimal time = OracleTimeOfImpact.circle(BigDecimal.TEN, less, v, BigDecimal.ZERO, two);
        assertTrue(BigDecimal.TEN.subtract(time).abs().doubleValue() < 1e-140, "" + time);
    }

    /** The blocks of G. Galperin, "Playing pool with pi", 2003: a wall, mass 1, mass 100^k: the first digits of pi. */
    @ParameterizedTest
    @CsvSource({"0, 3", "1, 31", "2, 314", "3, 3141"})
    @Tag("slow")
    void piBlocks(int k, int impacts) {
        List<OracleBody> state = OracleBody.of(
            Scenes.bodies(new double[][] {{10, 0, 0, 0, 1, 1}, {20, 0, -1, 0, StrictMath.pow(100, k), 1}}));
        BigDecimal energy = state.get(0).energy().add(state.get(1).energy());
        Oracle oracle = new Oracle(ImpactLaw.PHYSICS, List.of(new HalfPlane(0, 0, 1, 0, 1)));
        assertEquals(impacts, oracle.play(state, new BigDecimal(1000)).size());
        assertFalse(oracle.limited());
        BigDecimal after = state.get(0).energy().add(state.get(1).energy());
        assertTrue(after.subtract(energy).abs().compareTo(energy.multiply(TINY)) < 0);
    }

    /** Nine discs in a box: momentum changes only at walls, energy never; and back they go to 30 digits. */
    @Test
    void conservationAndTimeReversal() {
        SplitMix64 random = new SplitMix64(7);
        Bodies bodies = new Bodies(9);
        for (int k = 0; k < 9; k++) {
            bodies.add(100 + 200 * (k % 3) + 50 * random.nextDouble(), 100 + 200 * (k / 3) + 50 * random.nextDouble(),
                40, 1 + random.nextInt(5));
            bodies.setVelocity(k, 600 * random.nextDouble() - 300, 600 * random.nextDouble() - 300);
        }
        List<OracleBody> state = OracleBody.of(bodies);
        Oracle oracle = new Oracle(ImpactLaw.PHYSICS, List.of(Wall.box(650, 650, 1)));
        BigDecimal[] before = sums(state);
        List<OracleImpact> impacts = oracle.turn(state);
        assertTrue(impacts.size() >= 8, "impacts " + impacts.size());
        BigDecimal[] after = sums(state);
        assertNear(before[0], after[0]);
        BigDecimal gotX = BigDecimal.ZERO;
        BigDecimal gotY = BigDecimal.ZERO;
        for (OracleImpact impact : impacts) {
            int w = ~impact.b();
            gotX = gotX.add(w == 0 ? impact.impulse() : w == 2 ? impact.impulse().negate() : BigDecimal.ZERO);
            gotY = gotY.add(w == 1 ? impact.impulse() : w == 3 ? impact.impulse().negate() : BigDecimal.ZERO);
        }
        assertNear(before[1].add(gotX), after[1]);
        assertNear(before[2].add(gotY), after[2]);
        state.forEach(OracleBody::reverse);
        assertEquals(impacts.size(), oracle.turn(state).size());
        for (int k = 0; k < 9; k++) {
            assertTrue(DecimalErrors.relative(bodies.x[k], state.get(k).x, BigDecimal.ONE) < 1e-30, "body " + k);
            assertTrue(DecimalErrors.relative(bodies.vy[k], state.get(k).vy.negate(), BigDecimal.ONE) < 1e-30,
                "body " + k);
        }
    }

    private static BigDecimal[] sums(List<OracleBody> state) {
        BigDecimal[] sums = {BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ZERO};
        for (OracleBody body : state) {
            sums[0] = sums[0].add(body.energy());
            sums[1] = sums[1].add(body.vx.multiply(body.mass));
            sums[2] = sums[2].add(body.vy.multiply(body.mass));
        }
        return sums;
    }

    /** Three in a row and a collapse of impacts: the oracle stops at the bound, and says so. */
    @Test
    void aCollapseEndsAtTheBound() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 1000, 0}, {100, 0, 0, 0}, {200, 0, -1000, 0}});
        Scenes.setRestitution(bodies, 0.05);
        Oracle oracle = new Oracle(SOFT.withRestSpeed(0).withMaximumImpacts(40), List.of());
        assertEquals(40, oracle.turn(OracleBody.of(bodies)).size());
        assertTrue(oracle.limited());
    }

    /** One that bounces between two others far apart keeps its share of the speed at each impact. */
    @Test
    void manyImpactsWithoutAHeapAreNoRest() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 0, 0, 1e9}, {100, 0, 2000, 0, 1e-3}, {200, 0, 0, 0, 1e9}});
        Scenes.setRestitution(bodies, 0.99);
        Oracle oracle = new Oracle(SOFT, List.of());
        assertEquals(12, oracle.turn(OracleBody.of(bodies)).size());
        assertFalse(oracle.limited());
    }

    /** One ball on a floor under gravity, 300 turns: bounces, the last of them rest, then its weight in each turn. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.8, 1})
    void aBallThatFallsIsThatOfTheExactRung(double restitution) {
        Forces gravity = new Forces(0, 0, 0.25, 2);
        PhysicsParts parts = new PhysicsParts(restitution < 1 ? SOFT : ImpactLaw.PHYSICS, Arithmetic.EXACT,
            new Contacts(1), List.of(new HalfPlane(0, 0, 0, -1, 1)), null, false).withForces(gravity);
        Bodies bodies = new Bodies(1);
        bodies.add(3, -100, 10, 2);
        bodies.setRestitution(0, restitution);
        EventAdvance exact = new EventAdvance(parts);
        for (int turn = 0; turn < 300; turn++) {
            gravity.accelerate(bodies, 0, 0, 0);
            TurnTruth truth = TurnTruth.of(bodies, parts);
            TurnLog log = Scenes.turn(exact, bodies);
            assertEquals(truth.impacts(), log.impacts(), "turn " + turn);
            assertTrue(truth.positionError(bodies) < 1e-10, "turn " + turn + ": " + truth.positionError(bodies));
        }
        assertTrue(restitution == 1 || Math.abs(bodies.vy[0]) < 1e-9);
    }
}
