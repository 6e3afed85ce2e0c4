package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnLog;
import steward.physics.TurnSink;

/** Contacts that begin at a distance of their own, and what a reaction does after an impulse or within a batch. */
class OwnDistanceTest {

    private static final Contacts CONTACTS = new Contacts(2).askWithin(0, 1, 30);

    private final List<String> asked = new ArrayList<>();
    private final TurnLog log = new TurnLog();

    private static List<Advance> advances(Contacts contacts, Arithmetic arithmetic, Reaction reaction) {
        return Scenes.both(new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, contacts, List.of(), reaction, false));
    }

    /** Radii 10 and 10, at 100 u: they come within 30 after 70 u. */
    private static Bodies pair() {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 100, 0}, {100, 0, 0, 0}});
        bodies.setKind(1, 1);
        return bodies;
    }

    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void theReactionIsAskedAtThatDistance(Arithmetic arithmetic) {
        for (Advance advance : advances(CONTACTS, arithmetic, (time, a, b, all, sink) -> {
            asked.add(Math.round(1000 * time) / 1000.0 + " " + all.radius[a]);
            return Reaction.Verdict.PASS;
        })) {
            Bodies bodies = pair();
            advance.turn(bodies, log);

            assertEquals(List.of("0.7 10.0"), asked, "once, with its own radius");
            assertEquals(100, bodies.x[0], 1e-9);
            assertTrue(bodies.passing().contains(0, 1), "they are at the same place");
            advance.turn(bodies, log);
            assertTrue(bodies.passing().isEmpty(), "100 u on they are apart");
            asked.clear();
        }
    }

    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void anImpactThereIsOneAtThatDistance(Arithmetic arithmetic) {
        for (Advance advance : advances(CONTACTS, arithmetic,
            (time, a, b, all, sink) -> Reaction.Verdict.BOUNCE)) {
            Bodies bodies = pair();

            assertEquals(1, Scenes.turn(advance, bodies).impacts());
            assertEquals(70, bodies.x[0], 1e-9, "equal masses exchange their speeds");
            assertEquals(130, bodies.x[1], 1e-9);
            assertEquals(10, bodies.radius[0]);
        }
    }

    @Test
    void otherKindsTouchAtTheirRadii() {
        for (Advance advance : advances(CONTACTS, Arithmetic.DOUBLE,
            (time, a, b, all, sink) -> Reaction.Verdict.PASS)) {
            Bodies bodies = pair();
            bodies.setKind(1, 0);

            assertEquals(0.8, Scenes.turn(advance, bodies).impact(0).time(), 1e-12);
        }
    }

    @Test
    void stepsLookAtThatDistanceToo() {
        Bodies bodies = pair();
        new StepAdvance(new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, CONTACTS, List.of(),
            (time, a, b, all, sink) -> {
                asked.add("at " + time);
                return Reaction.Verdict.PASS;
            }, false), 4).turn(bodies, log);

        assertEquals(List.of("at 0.75"), asked);
    }

    @Test
    void aDistanceOfNothingIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Contacts(1).askWithin(0, 0, 0));
    }

    /** After the bounce of 0 and 1 the reaction gives 2, which is far away, another speed. */
    @Test
    void aReactionActsAfterTheImpulse() {
        Contacts contacts = new Contacts(2).set(0, 1, Contacts.Meaning.ASK);
        Reaction reaction = new Reaction() {
            @Override
            public Verdict on(double time, int a, int b, Bodies all, TurnSink sink) {
                asked.add("before " + all.vx[b]);
                return Verdict.BOUNCE;
            }

            @Override
            public boolean after(double time, int a, int b, Bodies all, TurnSink sink) {
                asked.add("after " + all.vx[b]);
                sink.fact(time, 3, all.id(a), all.id(b), 1, 2, 4, 5);
                all.setVelocity(2, 0, 50);
                return true;
            }
        };
        for (Advance advance : advances(contacts, Arithmetic.DOUBLE, reaction)) {
            asked.clear();
            log.clear();
            Bodies bodies = pair();
            Scenes.add(bodies, 0, 900, 0, 0, 1);
            advance.turn(bodies, log);

            assertEquals(List.of("before 0.0", "after 100.0"), asked);
            assertEquals(900 + 50 * 0.2, bodies.y[2], 1e-9);
            assertEquals(1, log.facts());
            assertEquals(List.of(3, 0, 1), List.of(log.factKind(0), log.factA(0), log.factB(0)));
            assertEquals(List.of(0.8, 1.0, 2.0, 4.0, 5.0),
                List.of(log.factTime(0), log.factX(0), log.factY(0), log.factP(0), log.factQ(0)));
        }
        log.clear();
        assertEquals(0, log.facts());
    }

    /** Under the official law three touch at once; the first answer alters, the second pair still has its turn. */
    @Test
    void anAlterationLetsTheBatchGoOn() {
        assertEquals(3, afterABatch((time, a, b, all, sink) -> {
            asked.add(all.id(a) + "," + all.id(b) + " at " + Math.round(1000 * time) / 1000.0);
            all.setPosition(a, all.x[a], 500 * (1 + all.id(a)));
            return Reaction.Verdict.ALTERED;
        }).size());
        assertEquals(List.of("2,1 at 0.05", "1,0 at 0.05"), asked,
            "in one batch: that 2 is gone does not matter to 1 and 0");
    }

    /** As a change: the rest of the batch would be about other bodies. */
    @Test
    void anAlterationThatRemovesDropsTheBatch() {
        assertEquals(1, afterABatch((time, a, b, all, sink) -> {
            asked.add(all.id(a) + "," + all.id(b));
            all.remove(a);
            return Reaction.Verdict.ALTERED;
        }).size());
        assertEquals(List.of("2,1", "1,0"), asked);
    }

    private Bodies afterABatch(Reaction reaction) {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 100, 0}, {25, 0, 0, 0}, {50, 0, -100, 0}});
        new EventAdvance(new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL,
            new Contacts(1).set(0, 0, Contacts.Meaning.ASK), List.of(), reaction, false)).turn(bodies, log);
        return bodies;
    }
}
