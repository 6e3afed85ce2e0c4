package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.Refusal;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * A crowd has the impacts that {@link EventAdvance} has, which looks at all pairs: the same in order, time and outcome,
 * to the last bit. One long file: all cases share what compares.
 */
@Execution(ExecutionMode.CONCURRENT)
class QueueAdvanceTest {

    private static final double SIDE = 1000;
    private static final Wall[] BOX = Wall.box(SIDE, SIDE, 1);
    private static final Wall[] ODD = {new Arena(500, 500, 700, 0.9), new Segment(200, 500, 700, 520, 1),
        new HalfPlane(0, 0, 0.6, 0.8, 0.8), new HalfPlane(1000, 1000, -1, 0, 1), new Segment(100, 900, 400, 950, 0.5)};

    private int impacts;

    @ParameterizedTest
    @Tag("slow")
    @EnumSource(Arithmetic.class)
    void boxesOfAnySizeHaveTheSameImpacts(Arithmetic arithmetic) {
        for (int perRow : new int[] {1, 2, 3, 5, 8, 14}) {
            for (long seed = 1; seed <= (arithmetic == Arithmetic.EXACT ? 2 : 4); seed++) {
                SplitMix64 random = new SplitMix64(seed);
                Bodies bodies = Scenes.grid(random, perRow, SIDE, 0.3 * SIDE / perRow, 0.7 * SIDE / perRow);
                compare("box, seed " + seed, Scenes.parts(ImpactLaw.PHYSICS, arithmetic, BOX), bodies, 6);
            }
        }
        assertTrue(impacts > 2000, impacts + " impacts");
    }

    /** Discs that cover 75%: many pairs would meet only after one of them has met another. */
    @ParameterizedTest
    @Tag("slow")
    @EnumSource(Arithmetic.class)
    void denseDiscsHaveTheSameImpacts(Arithmetic arithmetic) {
        for (long seed = 1; seed <= 3; seed++) {
            Bodies bodies = Scenes.grid(new SplitMix64(seed), 9, SIDE, 0.49 * SIDE / 9, 0.05 * SIDE);
            compare("dense, seed " + seed, Scenes.parts(ImpactLaw.PHYSICS, arithmetic, BOX), bodies, 2);
        }
        assertTrue(impacts > 1000, impacts + " impacts");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void allKindsOfWallsRestitutionAndMinimumImpulse(long seed) {
        SplitMix64 random = new SplitMix64(seed);
        Bodies bodies = mixed(random, 60, 2, 14);
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setRestitution(k, 0.5 + 0.5 * random.nextDouble());
        }
        ImpactLaw law = Scenes.WITH_RESTITUTION.withMinimumImpulse(5, seed % 2 == 0);
        compare("walls, seed " + seed, Scenes.parts(law, Arithmetic.DOUBLE, ODD), bodies, 8);
        assertTrue(impacts > 100, impacts + " impacts");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void fewLargeBodiesAmongManySmallOnes(long seed) {
        SplitMix64 random = new SplitMix64(seed);
        Bodies bodies = mixed(random, 180, 0.5, 4);
        for (int k = 0; k < 3; k++) {
            bodies.setRadius(60 * k + 30, 60 + 30 * k);
            bodies.setMass(60 * k + 30, k == 1 ? Double.POSITIVE_INFINITY : 500);
        }
        compare("large, seed " + seed, Scenes.parts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, BOX), bodies, 4);
        assertTrue(impacts > 100, impacts + " impacts");
    }

    /** Nobody comes back: in the end some are where the grid has wrapped around hundreds of times, some out of it. */
    @ParameterizedTest
    @ValueSource(doubles = {1e2, 1e4, 1e7, 1e10, 1e14})
    void withoutAFieldBodiesFlyAsFarAsTheyLike(double speed) {
        SplitMix64 random = new SplitMix64(5);
        Bodies bodies = mixed(random, 100, 2, 12);
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setVelocity(k, (k % 7 == 0 ? speed : 0.4) * bodies.vx[k], 0.4 * bodies.vy[k]);
        }
        for (int turn = 0; turn < 3; turn++) {
            compare("speed " + speed, Scenes.parts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE), bodies, 1);
        }
        assertTrue(impacts > 20, impacts + " impacts");
    }

    /** Rows that meet in the middle, all with the same few speeds: nearly all impacts are at the same instants. */
    @Test
    void tiesGoToTheLowestPair() {
        for (boolean descending : new boolean[] {false, true}) {
            for (int gap = 0; gap <= 2; gap++) {
                Bodies bodies = new Bodies(200);
                for (int k = 0; k < 196; k++) {
                    bodies.add(64 * (k % 14) + (20 + gap / 4.0) * (k % 2), 64 * (k / 14), 10, 1);
                    bodies.setVelocity(k, k % 14 < 7 ? 64 : -64, k / 14 < 7 ? 16 : -16);
                }
                ImpactLaw law = descending ? descending(ImpactLaw.PHYSICS) : ImpactLaw.PHYSICS;
                compare("lattice " + gap, Scenes.parts(law, Arithmetic.DOUBLE), bodies, 1);
            }
        }
        assertTrue(impacts > 100, impacts + " impacts");
    }

    /**
     * Pairs that touch exactly at the end of the turn, or would 2^-40 u later: all numbers are short, so that the time
     * is 1 and nothing but 1, which is an impact of this turn. All drift along, over many cells or none.
     */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void impactsAtTheVeryEndOfTheTurn(Arithmetic arithmetic) {
        for (int hair = 0; hair <= 1; hair++) {
            for (int drift : new int[] {0, 96, -1600}) {
                Bodies bodies = new Bodies(120);
                double off = hair * 0x1p-40;
                for (int k = 0; k < 60; k++) {
                    double x = 160 * (k % 10) + 48;
                    double y = 160 * (k / 10) + 48;
                    Scenes.add(bodies, x, y, drift, -drift / 4, 1);
                    switch (k % 4) {
                        case 0 -> Scenes.add(bodies, x + 64 + off, y, drift - 44, -drift / 4, 1);
                        case 1 -> Scenes.add(bodies, x, y - 64 - off, drift, 44 - drift / 4, 1);
                        case 2 -> Scenes.add(bodies, x + 39 + off, y + 52, drift - 27, -36 - drift / 4, 1);
                        default -> Scenes.add(bodies, x - 64 - off, y, drift + 44, -drift / 4, 1);
                    }
                }
                int before = impacts;
                compare("end " + hair + ", drift " + drift, Scenes.parts(ImpactLaw.PHYSICS, arithmetic), bodies, 1);
                assertEquals(hair > 0 ? 0 : 60, impacts - before, "hair " + hair + ", drift " + drift);
            }
        }
    }

    /**
     * A wall is met at t = 1/2 or 1/8, and on the way back somebody, or the other wall, at t = 1. Where that time is
     * rounded up, it is t = 0 of the next turn: which of the two, in plain doubles, is an accident of either advance,
     * and nobody meets twice or not at all.
     */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void impactsAtTheVeryEndAfterOthers(Arithmetic arithmetic) {
        Wall[] walls = {new HalfPlane(0, -30, 0, 1, 1), new HalfPlane(0, 130, 0, -1, 1)};
        PhysicsParts parts = Scenes.parts(ImpactLaw.PHYSICS, arithmetic, walls);
        Bodies bodies = new Bodies(90);
        for (int k = 0; k < 30; k++) {
            double x = 256 * k;
            Scenes.add(bodies, x, 0, 0, -40, 1);
            Scenes.add(bodies, x + 64, 0, -44, 0, 1);
            Scenes.add(bodies, x + 128, 0, 0, -160, 1);
        }
        Bodies other = bodies.copy();
        List<String> expected = untilHalfOfTheSecondTurn(new EventAdvance(parts), bodies);
        assertEquals(120, expected.size());
        assertEquals(expected, untilHalfOfTheSecondTurn(new QueueAdvance(parts), other));
    }

    /** Who meets and when, to some digits; sorted, because of those at one time. */
    private static List<String> untilHalfOfTheSecondTurn(Advance advance, Bodies bodies) {
        List<String> meetings = new ArrayList<>();
        for (int turn = 0; turn < 2; turn++) {
            TurnLog log = Scenes.turn(advance, bodies);
            for (int k = 0; k < log.impacts() && (turn == 0 || log.impact(k).time() < 0.5); k++) {
                Impact impact = log.impact(k);
                meetings.add(String.format(Locale.ROOT, "%.6f %d-%d", turn + impact.time(), impact.a(), impact.b()));
            }
        }
        Collections.sort(meetings);
        return meetings;
    }

    /** One hits two that stand side by side, both at the same instant: the lower pair is first. */
    @Test
    void aBodyWithTwoImpactsAtOnceHasTheLowerOneFirst() {
        for (int hitter = 0; hitter < 3; hitter++) {
            Bodies bodies = new Bodies(3);
            for (int k = 0; k < 3; k++) {
                boolean left = k == (hitter + 1) % 3;
                Scenes.add(bodies, k == hitter ? 0 : 64, k == hitter ? 0 : left ? -12 : 12,
                    k == hitter ? 100 : 0, 0, 1);
            }
            compare("hitter " + hitter, Scenes.parts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE), bodies, 1);
        }
        assertTrue(impacts >= 6, impacts + " impacts");
    }

    /**
     * Bodies that have exchanged impulses at one instant, after which two of them approach by a rounding error: an
     * impact for arithmetics that see it. Found among 100,000 worlds on a lattice, less the bodies that do not count.
     */
    @Test
    void anApproachByARoundingErrorIsNotOverlooked() {
        compareOnLattice(Arithmetic.EXACT, new double[][] {{224, 264, 64, 16}, {264, 224, 0, 64},
            {264, 264, 0, 16}, {304, 264, -32, 48}});
        compareOnLattice(Arithmetic.COMPENSATED, new double[][] {{124, 124, 64, -32}, {144, 124, 64, 64},
            {104, 104, 64, -16}, {164, 184, 64, -64}, {124, 104, -32, -64}, {144, 144, -48, -32}, {164, 144, -64, -16},
            {144, 104, -16, -32}, {164, 164, 64, 0}});
        assertTrue(impacts > 10, impacts + " impacts");
    }

    private void compareOnLattice(Arithmetic arithmetic, double[][] world) {
        compare(arithmetic + ", lattice", Scenes.parts(ImpactLaw.PHYSICS, arithmetic), Scenes.bodies(world), 1);
    }

    /** At a slanted wall, which bodies touch and along which they move but for rounding. */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void nearlySlidingAlongASlantedWallIsNotOverlooked(Arithmetic arithmetic) {
        SplitMix64 random = new SplitMix64(12);
        PhysicsParts parts = Scenes.parts(Scenes.WITH_RESTITUTION, arithmetic, new HalfPlane(0, 0, 0.6, 0.8, 0.9));
        for (int n = 0; n < 2000; n++) {
            double along = 100 * random.nextDouble();
            double speed = 100 * random.nextDouble();
            Bodies bodies = Scenes.bodies(new double[][] {
                {0.6 * 10 + 0.8 * along, 0.8 * 10 - 0.6 * along, 0.8 * speed, -0.6 * speed}});
            compare("slanted " + n, parts, bodies, 1);
        }
        assertTrue(impacts > 100, impacts + " impacts");
    }

    /**
     * Touching bodies are pushed apart. In plain doubles it hangs on the sign of a rounding whether those do that have
     * just met, and the two advances round differently; the exact arithmetic sees it as it is.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-5, 1e-3, 0.5})
    void pushOutOfThoseThatMeet(double pushOut) {
        for (long seed = 1; seed <= 4; seed++) {
            Bodies bodies = mixed(new SplitMix64(seed), 60, 10, 20);
            compare("push " + pushOut + ", seed " + seed, Scenes.parts(ImpactLaw.PHYSICS.withPushOut(pushOut),
                Arithmetic.EXACT, BOX), bodies, 4);
        }
        assertTrue(impacts > 400, impacts + " impacts");
    }

    /** Some overlap at first. A push-out above 0 would hang on the sign of a rounding, which differs. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void pushOutAndInfiniteMasses(long seed) {
        SplitMix64 random = new SplitMix64(seed);
        Bodies bodies = mixed(random, 60, 10, 20);
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setRadius(k, bodies.radius[k] * 1.25);
            bodies.setMass(k, k % 5 == 0 ? Double.POSITIVE_INFINITY : bodies.mass[k]);
        }
        ImpactLaw law = ImpactLaw.PHYSICS.withPushOut(0);
        compare("push, seed " + seed, Scenes.parts(law, Arithmetic.DOUBLE, BOX), bodies, 4);
        assertTrue(impacts > 100, impacts + " impacts");
    }

    /** Kind 0 bounces, kind 1 ignores itself and asks kind 0, kind 2 asks all and walls; asked ones answer anything. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void whoIsAskedAnswers(long seed) {
        Contacts contacts = new Contacts(3).set(1, 1, Contacts.Meaning.NONE).set(0, 1, Contacts.Meaning.ASK)
            .set(2, 0, Contacts.Meaning.ASK).set(2, 1, Contacts.Meaning.ASK).setWall(2, Contacts.Meaning.ASK)
            .setWall(1, Contacts.Meaning.NONE);
        Reaction reaction = (time, a, b, bodies, sink) -> {
            int id = bodies.id(a) + (b < 0 ? b : bodies.id(b));
            if (id % 11 == 0 && bodies.size() > 10) {
                bodies.remove(b < 0 ? a : b);
                return Reaction.Verdict.CHANGED;
            }
            if (id % 7 == 0) {
                bodies.setVelocity(a, -bodies.vx[a], 10 - bodies.vy[a]);
                if (b >= 0) {
                    bodies.setVelocity(b, -bodies.vx[b], -10 - bodies.vy[b]);
                }
                return Reaction.Verdict.CHANGED;
            }
            return id % 3 == 0 ? Reaction.Verdict.PASS : Reaction.Verdict.BOUNCE;
        };
        SplitMix64 random = new SplitMix64(seed);
        Bodies bodies = mixed(random, 70, 10, 25);
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setKind(k, k % 3);
        }
        compare("ask, seed " + seed, new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, contacts,
            List.of(seed % 2 == 0 ? BOX : ODD), reaction, false), bodies, 5);
        assertTrue(impacts > 50, "impacts " + impacts);
    }

    /** Some contacts begin farther away than the radii say, others at less; walls are met at the radius. */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void contactsAtADistanceOfTheirOwn(Arithmetic arithmetic) {
        Contacts contacts = new Contacts(3).askWithin(0, 1, 70).askWithin(1, 1, 8).set(2, 1, Contacts.Meaning.NONE);
        Reaction reaction = (time, a, b, bodies, sink) -> (bodies.id(a) + bodies.id(b)) % 3 == 0
            ? Reaction.Verdict.PASS : Reaction.Verdict.BOUNCE;
        for (long seed = 1; seed <= 3; seed++) {
            Bodies bodies = mixed(new SplitMix64(seed), 60, 5, 20);
            for (int k = 0; k < bodies.size(); k++) {
                bodies.setKind(k, k % 3);
            }
            compare("reach, seed " + seed, new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, contacts,
                List.of(seed % 2 == 0 ? BOX : ODD), reaction, false), bodies, 3);
        }
        assertTrue(impacts > 100, impacts + " impacts");
    }

    /** After its impulse a reaction makes both of a pair larger, so that they meet others sooner. */
    @Test
    void thoseThatGrowInAnImpactMeetOthersSooner() {
        Contacts contacts = new Contacts(1).set(0, 0, Contacts.Meaning.ASK);
        Reaction reaction = new Reaction() {
            @Override
            public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
                return Verdict.BOUNCE;
            }

            @Override
            public boolean after(double time, int a, int b, Bodies bodies, TurnSink sink) {
                bodies.setRadius(a, Math.min(bodies.radius[a] * 1.25, 12));
                bodies.setRadius(b, Math.min(bodies.radius[b] * 1.25, 12));
                return false;
            }
        };
        Bodies bodies = mixed(new SplitMix64(1), 60, 2, 5);
        compare("growing", new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, contacts, List.of(BOX), reaction,
            false), bodies, 4);
        assertTrue(impacts > 50, impacts + " impacts");
    }

    /** The last two bodies are removed where they meet. */
    @Test
    void aTurnMayEndWithoutBodies() {
        Contacts contacts = new Contacts(1).set(0, 0, Contacts.Meaning.ASK);
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 100, 0}, {64, 0, 0, 0}});
        compare("nobody left", new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, contacts, List.of(),
            (time, a, b, all, sink) -> {
                all.remove(b);
                all.remove(a);
                return Reaction.Verdict.CHANGED;
            }, false), bodies, 2);
        assertEquals(0, bodies.size());
    }

    /** At the bound, whoever touches or runs into something stays; the others fly on. */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void theBoundOnImpactsIsKeptTheSameWay(Arithmetic arithmetic) {
        for (int bound : new int[] {1, 2, 10, 50}) {
            for (long seed = 1; seed <= 4; seed++) {
                Bodies bodies = mixed(new SplitMix64(seed), 90, 10, 25);
                ImpactLaw law = ImpactLaw.PHYSICS.withMaximumImpacts(bound);
                compare("bound, seed " + seed, Scenes.parts(law, arithmetic, BOX), bodies, 1);
            }
        }
    }

    @Test
    void lawsWithBatchesAreRefused() {
        assertNull(QueueAdvance.refusal(ImpactLaw.PHYSICS));
        assertNotNull(QueueAdvance.refusal(ImpactLaw.OFFICIAL_POD_RACE));
        PhysicsParts parts = Scenes.parts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL);
        Refusal.refused("queue: impacts within batchWindow react together", () -> new QueueAdvance(parts));
    }

    /** Cells that are full, bodies in none, and rings shorter than what is read of them. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 40, 400})
    @Tag("slow")
    void readingAheadChangesNothing(int count) {
        for (Arithmetic arithmetic : List.of(Arithmetic.DOUBLE, Arithmetic.EXACT)) {
            SplitMix64 random = new SplitMix64(count);
            Bodies bodies = mixed(random, count, 0.5, count > 100 ? 8 : 30);
            bodies.setRadius(0, bodies.radius[0] / 100);
            bodies.setVelocity(0, 1e5, 0);
            Advance reading = new QueueAdvance(Scenes.parts(ImpactLaw.PHYSICS, arithmetic, BOX), 1);
            Advance plain = new QueueAdvance(Scenes.parts(ImpactLaw.PHYSICS, arithmetic, BOX));
            for (int turn = 0; turn < 4; turn++) {
                impacts += Scenes.assertSameTurn(plain, reading, bodies, arithmetic + ", turn " + turn);
            }
        }
        assertTrue(impacts > 2, impacts + " impacts");
    }

    private static ImpactLaw descending(ImpactLaw law) {
        return new ImpactLaw(law.restitution(), law.minimumImpulse(), law.minimumImpulseAtWalls(), law.deadZone(),
            law.separatingPairsReact(), law.batchWindow(), ImpactLaw.ScanOrder.DESCENDING, law.pushOut(),
            law.maximumImpacts());
    }

    /** Radii between the two, at random places where nobody else is. */
    private static Bodies mixed(SplitMix64 random, int count, double least, double most) {
        Bodies bodies = new Bodies(count);
        while (bodies.size() < count) {
            double radius = least + (most - least) * random.nextDouble();
            double x = 150 + 700 * random.nextDouble();
            double y = 250 + 650 * random.nextDouble();
            boolean free = true;
            for (int k = 0; k < bodies.size(); k++) {
                free &= Math.hypot(bodies.x[k] - x, bodies.y[k] - y) > bodies.radius[k] + radius;
            }
            if (free) {
                int k = bodies.add(x, y, radius, 1 + 3 * random.nextDouble());
                bodies.setVelocity(k, 300 * random.nextDouble() - 150, 300 * random.nextDouble() - 150);
            }
        }
        return bodies;
    }

    private void compare(String what, PhysicsParts parts, Bodies bodies, int turns) {
        Advance event = new EventAdvance(parts);
        Advance queue = new QueueAdvance(parts);
        Bodies other = new Bodies(bodies.capacity());
        for (int turn = 0; turn < turns; turn++) {
            String where = what + ", " + bodies.size() + " bodies, turn " + turn;
            other.copyFrom(bodies);
            TurnLog expected = Scenes.turn(event, bodies);
            compare(where, expected, Scenes.turn(queue, other));
            assertEquals(bodies.size(), other.size(), where);
            assertEquals(bodies.passing().size(), other.passing().size(), where);
            for (int k = 0; k < bodies.size(); k++) {
                String body = where + ", body " + bodies.id(k);
                assertEquals(bodies.id(k), other.id(k), where);
                assertSame(bodies.x[k], other.x[k], body);
                assertSame(bodies.y[k], other.y[k], body);
                assertSame(bodies.vx[k], other.vx[k], body);
                assertSame(bodies.vy[k], other.vy[k], body);
            }
        }
    }

    private void compare(String where, TurnLog expected, TurnLog seen) {
        for (int k = 0; k < Math.min(expected.impacts(), seen.impacts()); k++) {
            Impact a = expected.impact(k);
            Impact b = seen.impact(k);
            String impact = where + ", impact " + k + " of " + expected.impacts();
            assertEquals(a.a() + "-" + a.b(), b.a() + "-" + b.b(), () -> impact + " at " + a.time() + ", " + b.time());
            assertSame(a.time(), b.time(), impact);
            assertSame(a.impulse(), b.impulse(), impact);
        }
        assertEquals(expected.impacts(), seen.impacts(), where);
        assertSame(expected.limitTime(), seen.limitTime(), where);
        assertArrayEquals(expected.limitBodies(), seen.limitBodies(), where);
        impacts += expected.impacts();
    }

    /** Equal to the last bit, but for the sign of 0. */
    private static void assertSame(double expected, double seen, String where) {
        assertEquals(expected + 0.0, seen + 0.0, where);
    }
}
