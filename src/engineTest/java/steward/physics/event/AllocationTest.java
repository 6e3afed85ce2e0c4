package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.match.Allocated;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** A turn allocates nothing once its buffers have grown: counted by the JVM, to the byte. */
class AllocationTest {

    private static final Wall[] NO_WALLS = {};
    private static final Wall[] WALLS = {new HalfPlane(0, 0, 1, 0, 0.9), new HalfPlane(0, 0, 0, 1, 1),
        new Segment(6000, 0, 6000, 6000, 0.9), new Arena(3000, 3000, 4500, 1)};

    @Test
    void theOfficialLawAllocatesNothing() {
        check(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL, NO_WALLS, false);
        check(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL, WALLS, false);
    }

    @Test
    void theLawOfPhysicsAllocatesNothing() {
        check(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, NO_WALLS, false);
        check(Scenes.WITH_RESTITUTION.withMinimumImpulse(120, false), Arithmetic.DOUBLE, WALLS, false);
    }

    /** Compensated and exact times too, in either law; the searches' steps by their own test. */
    @Test
    void theHigherRungsAllocateNothing() {
        for (Arithmetic arithmetic : List.of(Arithmetic.COMPENSATED, Arithmetic.EXACT)) {
            check(ImpactLaw.OFFICIAL_POD_RACE, arithmetic, NO_WALLS, false);
            check(Scenes.WITH_RESTITUTION, arithmetic, WALLS, false);
        }
        check(ImpactLaw.PHYSICS, Arithmetic.EXACT, WALLS, true);
    }

    @Test
    void stepsAllocateNothing() {
        PhysicsParts parts = new PhysicsParts(Scenes.WITH_RESTITUTION, Arithmetic.DOUBLE, new Contacts(1),
            List.of(WALLS), null, false);
        check(new StepAdvance(parts, 1));
        check(new StepAdvance(parts, 16));
    }

    @Test
    void crowdsAllocateNothing() {
        for (Arithmetic arithmetic : Arithmetic.values()) {
            check(new QueueAdvance(Scenes.parts(Scenes.WITH_RESTITUTION.withPushOut(0.5), arithmetic, WALLS)));
        }
        Contacts asking = new Contacts(1).set(0, 0, Contacts.Meaning.ASK);
        check(new QueueAdvance(new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, asking, List.of(WALLS),
            (time, a, b, bodies, sink) -> (a + b) % 2 == 0 ? Reaction.Verdict.PASS : Reaction.Verdict.BOUNCE, false)));
    }

    @Test
    void askingAllocatesNothing() {
        check(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, WALLS, true);
    }

    private static void check(ImpactLaw law, Arithmetic arithmetic, Wall[] walls, boolean asks) {
        Contacts contacts = new Contacts(1);
        if (asks) {
            contacts.set(0, 0, Contacts.Meaning.ASK).setWall(0, Contacts.Meaning.ASK);
        }
        Reaction reaction = asks ? (time, a, b, bodies, sink) -> (a + b) % 2 == 0 ? Reaction.Verdict.PASS
            : Reaction.Verdict.BOUNCE : null;
        check(new EventAdvance(new PhysicsParts(law, arithmetic, contacts, List.of(walls), reaction, false)));
    }

    /**
     * 6 pods, started anew every 10 turns; 2,000 turns to warm up, then 1,000 counted. They are the same turns every
     * time, so that whatever they allocate shows in every count; what the JVM itself once adds (resolving, compiling)
     * does not, and one of five counts must be 0.
     */
    private static void check(Advance advance) {
        SplitMix64 random = new SplitMix64(1);
        Bodies start = new Bodies(6);
        for (int k = 0; k < 6; k++) {
            start.add(1500 + 1500 * (k % 3), 1500 + 1500 * (k / 3), 400, 1 + k);
            start.setVelocity(k, 2000 * random.nextDouble() - 1000, 2000 * random.nextDouble() - 1000);
        }
        Bodies bodies = new Bodies(6);
        TurnLog log = new TurnLog();
        play(advance, start, bodies, log, 2000);
        assertTrue(log.impacts() > 0, "nothing happened in the last turns");
        Allocated.assertNone(5, "1,000 turns", () -> Allocated.by(() -> play(advance, start, bodies, log, 1000)));
    }

    private static void play(Advance advance, Bodies start, Bodies bodies, TurnLog log, int turns) {
        for (int turn = 0; turn < turns; turn++) {
            if (turn % 10 == 0) {
                bodies.copyFrom(start);
                log.clear();
            }
            advance.turn(bodies, log);
        }
    }
}
