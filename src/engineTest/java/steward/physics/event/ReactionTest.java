package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.Reaction.Verdict;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** Meanings of contacts, when the scene is asked, and the effect of each of its answers. */
class ReactionTest {

    private final List<String> asked = new ArrayList<>();
    private final TurnLog log = new TurnLog();

    /** Two kinds; 0 against 1 means what is said, everything else bounces; the reaction notes each question. */
    private EventAdvance advance(Meaning meaning, Reaction reaction, Wall... walls) {
        Contacts contacts = new Contacts(2).set(0, 1, meaning);
        if (walls.length > 0) {
            contacts.setWall(0, meaning);
        }
        return new EventAdvance(new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, contacts, List.of(walls),
            reaction == null ? null : noting(reaction), true));
    }

    private Reaction noting(Reaction reaction) {
        return (time, a, b, bodies, sink) -> {
            asked.add(bodies.id(a) + "," + (b < 0 ? b : bodies.id(b)) + " at " + Math.round(1000 * time) / 1000.0);
            return reaction.on(time, a, b, bodies, sink);
        };
    }

    private static Reaction always(Verdict verdict) {
        return (time, a, b, bodies, sink) -> verdict;
    }

    /** 80 u of room at 100 u per turn; kinds 0 and 1. */
    private static Bodies pair(double massA, double massB) {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 100, 0, massA}, {100, 0, 0, 0, massB}});
        bodies.setKind(1, 1);
        return bodies;
    }

    @Test
    void whoIgnoresOthersOrWallsFliesThrough() {
        assertFliesThrough(pair(1, 1), advance(Meaning.NONE, null));
        assertFliesThrough(pair(1, 1), advance(Meaning.NONE, null, new HalfPlane(50, 0, -1, 0, 1)));
    }

    private void assertFliesThrough(Bodies bodies, Advance advance) {
        advance.turn(bodies, log);
        assertEquals(100, bodies.x[0]);
        assertEquals(0, log.impacts());
    }

    @Test
    void bounceIsTheSameAsNotAsking() {
        for (long seed = 1; seed <= 100; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            Bodies bodies = Scenes.grid(random, 3, 600, 60, 500);
            for (int k = 0; k < 9; k++) {
                bodies.setKind(k, random.nextInt(2));
            }
            Wall[] walls = Wall.box(600, 600, 1);
            EventAdvance plain = advance(Meaning.BOUNCE, null, walls);
            EventAdvance asking = advance(Meaning.ASK, always(Verdict.BOUNCE), walls);
            for (int turn = 0; turn < 3; turn++) {
                Scenes.assertSameTurn(plain, asking, bodies, "seed " + seed);
            }
            assertTrue(bodies.passing().isEmpty());
        }
        assertTrue(asked.size() > 500, asked.size() + " questions");
    }

    /** Asked at the exact time, at the touching distance, with the speeds before. */
    @Test
    void theQuestionShowsTheTouchBeforeAnyImpulse() {
        Bodies bodies = pair(1, 1);
        advance(Meaning.ASK, (time, a, b, all, sink) -> {
            assertEquals(0.8, time, 1e-15);
            assertArrayEquals(new double[] {80, 100, 100, 0}, new double[] {all.x[a], all.x[b], all.vx[a], all.vx[b]},
                1e-12);
            return Verdict.BOUNCE;
        }).turn(bodies, log);
        assertEquals(List.of("0,1 at 0.8"), asked);
        assertEquals(100, bodies.vx[1]);
    }

    /**
     * From touch at x = 80 to parting at x = 120, 40 u at 100 u per turn: over the end of the turn, asked once. Then it
     * comes back and is asked again.
     */
    @Test
    void whoPassesIsNotAskedAgainUntilTheyHaveSeparated() {
        Bodies bodies = pair(1, 1);
        EventAdvance advance = advance(Meaning.ASK, always(Verdict.PASS));
        advance.turn(bodies, log);
        assertEquals(100, bodies.x[0]);
        assertTrue(bodies.passing().contains(0, 1) && bodies.passing().size() == 1);
        bodies.setVelocity(0, 10, 0);
        advance.turn(bodies, log);
        assertEquals(1, bodies.passing().size(), "still within each other");
        bodies.setVelocity(0, -5, 0);
        advance.turn(bodies, log);
        assertEquals(1, bodies.passing().size(), "turning round inside is not parting");
        bodies.setVelocity(0, 100, 0);
        advance.turn(bodies, log);
        assertTrue(bodies.passing().isEmpty(), "at x = 205 they are apart");
        assertEquals(List.of("0,1 at 0.8"), asked);
        bodies.setVelocity(0, -100, 0);
        advance.turn(bodies, log);
        assertEquals(List.of("0,1 at 0.8", "0,1 at 0.85"), asked, "from 205 to 120 at 100 u per turn");
        assertEquals(0, log.impacts());
    }

    /** Slow and oblique, so that touch, closest approach and parting are all rounded: one question per passage. */
    @Test
    void everyPassageHasOneQuestion() {
        for (long seed = 1; seed <= 500; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            double aim = 38 * (random.nextDouble() - 0.5);
            double angle = 2 * Math.PI * random.nextDouble();
            Bodies bodies = new Bodies(2);
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            double speed = 1 + 30 * random.nextDouble();
            Scenes.add(bodies, -60 * cos - aim * sin, -60 * sin + aim * cos, speed * cos, speed * sin, 1);
            Scenes.add(bodies, 0, 0, 0, 0, 1);
            bodies.setKind(1, 1);
            EventAdvance advance = advance(Meaning.ASK, always(Verdict.PASS));
            for (int turn = 0; turn < 120 / speed + 1; turn++) {
                advance.turn(bodies, log);
            }
            assertEquals(seed, asked.size(), "seed " + seed);
            assertTrue(bodies.passing().isEmpty(), "seed " + seed);
        }
    }

    /**
     * <pre>
     *      O-->   |        through a segment at x = 50: touch at 40, parted at 60, back again later
     * </pre>
     */
    @Test
    void aWallCanBePassed() {
        Bodies bodies = pair(1, 1);
        bodies.setPosition(1, 500, 500);
        EventAdvance advance = advance(Meaning.ASK, always(Verdict.PASS), new Segment(50, -50, 50, 50, 1));
        bodies.setVelocity(0, 50, 0);
        advance.turn(bodies, log);
        assertTrue(bodies.passing().contains(0, ~0), "at x = 50, in the middle of it");
        advance.turn(bodies, log);
        assertTrue(bodies.passing().isEmpty());
        bodies.setVelocity(0, -50, 0);
        advance.turn(bodies, log);
        assertEquals(List.of("0,-1 at 0.8", "0,-1 at 0.8"), asked);
        assertEquals(0, log.impacts());
    }

    @Test
    void aCopyInTheMiddleOfAPassageGoesOnAlike() {
        Bodies bodies = pair(1, 1);
        EventAdvance advance = advance(Meaning.ASK,
            (time, a, b, all, sink) -> asked.size() == 1 ? Verdict.PASS : Verdict.BOUNCE);
        advance.turn(bodies, log);
        Scenes.assertSameTurn(advance, advance, bodies, "of a copy");
        assertEquals(1, asked.size());
    }

    /** The passing pair is known by ids: the one in front of it goes, and it passes on. */
    @Test
    void removalDoesNotDisturbWhoPasses() {
        Bodies bodies = Scenes.bodies(new double[][] {{900, 900, 0, 0}, {0, 0, 100, 0}, {100, 0, 0, 0}});
        bodies.setKind(2, 1);
        EventAdvance advance = advance(Meaning.ASK, always(Verdict.PASS));
        advance.turn(bodies, log);
        bodies.remove(0);
        bodies.setVelocity(0, 10, 0);
        advance.turn(bodies, log);
        assertTrue(bodies.passing().contains(1, 2));
        bodies.remove(1);
        advance.turn(bodies, log);
        assertTrue(bodies.passing().isEmpty(), "one of them is gone");
        assertEquals(List.of("1,2 at 0.8"), asked);
    }

    /** The second body is taken away at the touch; what was behind it is hit instead, in the same turn. */
    @Test
    void aBodyTakenAwayInsideATurnIsGoneAtOnce() {
        Bodies bodies = pair(1, 1);
        Scenes.add(bodies, 110, 0, 0, 0, 1);
        bodies.remove(1);
        bodies.add(100, 0, 10, 1);
        bodies.setKind(2, 1);
        bodies.setPosition(1, 115, 0);
        advance(Meaning.ASK, (time, a, b, all, sink) -> {
            all.remove(b);
            return Verdict.CHANGED;
        }).turn(bodies, log);
        assertEquals(2, bodies.size());
        assertEquals(List.of("0,3 at 0.8"), asked);
        assertEquals(0.95, log.impact(0).time(), 1e-12, "then the one at 115");
        assertEquals(100, bodies.vx[1], 1e-12);
    }

    /** At the touch the target splits into two that fly off to the sides; they bounce off others in the same turn. */
    @Test
    void bodiesBornInsideATurnTakePartInIt() {
        Bodies bodies = pair(1, 1);
        Scenes.add(bodies, 100, 45, 0, 0, 1);
        advance(Meaning.ASK, (time, a, b, all, sink) -> {
            double x = all.x[b];
            all.remove(b);
            Scenes.add(all, x, 10, 0, 100, 1);
            Scenes.add(all, x, -10.5, 0, -100, 1);
            return Verdict.CHANGED;
        }).turn(bodies, log);
        assertEquals(4, bodies.size());
        assertArrayEquals(new int[] {0, 2, 3, 4}, new int[] {bodies.id(0), bodies.id(1), bodies.id(2), bodies.id(3)});
        boolean hit = false;
        for (int k = 0; k < log.impacts(); k++) {
            hit |= log.impact(k).a() == 2 && log.impact(k).b() == 3 && Math.abs(log.impact(k).time() - 0.95) < 1e-9;
        }
        assertTrue(hit, "the upper half reaches y = 25 after 15 u");
        assertEquals(-10.5 - 0.2 * 100, bodies.y[3], 1e-9, "the lower one flies for what is left of the turn");
    }

    /** Under the official law three touch at once; the first answer drops the rest of the batch, to be found anew. */
    @Test
    void aChangeDropsTheRestOfTheBatch() {
        Contacts contacts = new Contacts(1).set(0, 0, Meaning.ASK);
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 100, 0}, {25, 0, 0, 0}, {50, 0, -100, 0}});
        new EventAdvance(new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL, contacts, List.of(),
            noting((time, a, b, all, sink) -> {
                all.remove(a);
                return Verdict.CHANGED;
            }), false)).turn(bodies, log);
        assertEquals(List.of("2,1 at 0.05", "1,0 at 0.05"), asked, "2 goes, then 1 is asked about anew and goes");
        assertEquals(1, bodies.size());
    }

    @Test
    void twoInfiniteMassesNeverExchangeAnImpulse() {
        Bodies bodies = pair(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        assertFliesThrough(bodies, advance(Meaning.ASK, always(Verdict.BOUNCE)));
        assertEquals(1, asked.size());
        assertTrue(bodies.passing().contains(0, 1), "those that are to bounce pass");
        assertFliesThrough(pair(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY), advance(Meaning.BOUNCE, null));
    }

    /** Documented: it is asked again and again, and the bound ends it. */
    @Test
    void sayingChangedWithoutChangingAnythingEndsAtTheBound() {
        Bodies bodies = pair(1, 1);
        advance(Meaning.ASK, always(Verdict.CHANGED)).turn(bodies, log);
        assertTrue(log.limited());
        assertEquals(12_000, asked.size());
        assertArrayEquals(new int[] {0, 1}, log.limitBodies());
        assertEquals(0.8, log.limitTime(), 1e-12);
    }
}
