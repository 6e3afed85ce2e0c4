package steward.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static steward.match.Refusal.refused;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.ImpactLaw.ScanOrder;

/** Which laws can be, and that changing one thing changes nothing else. */
class ImpactLawTest {

    private static final double NAN = Double.NaN;
    private static final double INFINITY = Double.POSITIVE_INFINITY;

    @Test
    void valuesOutOfRangeAreRefusedByName() {
        ImpactLaw law = ImpactLaw.PHYSICS;
        refused("impact law: minimumImpulse -1.0, expected finite and at least 0",
            () -> law.withMinimumImpulse(-1, false));
        refused("impact law: minimumImpulse NaN, expected finite and at least 0",
            () -> law.withMinimumImpulse(NAN, false));
        refused("impact law: minimumImpulse Infinity, expected finite and at least 0",
            () -> law.withMinimumImpulse(INFINITY, true));
        refused("impact law: deadZone -0.1, expected at least 0", () -> law.withDeadZone(-0.1));
        refused("impact law: pushOut -1.0, expected finite and at least 0", () -> law.withPushOut(-1));
        refused("impact law: pushOut Infinity, expected finite and at least 0", () -> law.withPushOut(INFINITY));
        refused("impact law: maximumImpacts -1.0, expected at least 0", () -> law.withMaximumImpacts(-1));
        refused("impact law: batchWindow -0.1, expected 0..1", () -> batch(true, -0.1));
        refused("impact law: batchWindow 1.5, expected 0..1", () -> batch(true, 1.5));
        refused("impact law: batchWindow NaN, expected 0..1", () -> batch(true, NAN));
    }

    /** A touching pair that separates with nothing to gain would react forever. */
    @Test
    void whatDoesNotGoTogetherIsRefused() {
        refused("impact law: minimumImpulse 0.0, expected above 0, because separating pairs react",
            () -> ImpactLaw.OFFICIAL_POD_RACE.withMinimumImpulse(0, false));
        refused("impact law: batchWindow 1.0E-5, expected 0, because only approaching pairs react",
            () -> batch(false, 1e-5));
    }

    private static ImpactLaw batch(boolean separatingPairsReact, double window) {
        return new ImpactLaw(Restitution.ELASTIC, 120, false, NAN, separatingPairsReact, window, ScanOrder.ASCENDING,
            NAN, 0);
    }

    @Test
    void eachChangeChangesThatAlone() {
        ImpactLaw law = new ImpactLaw(Restitution.ELASTIC, 1, true, 2, true, 0.5, ScanOrder.DESCENDING, 3, 4);
        assertEquals(new ImpactLaw(Restitution.MINIMUM, 1, true, 2, true, 0.5, ScanOrder.DESCENDING, 3, 4),
            law.withRestitution(Restitution.MINIMUM));
        assertEquals(new ImpactLaw(Restitution.ELASTIC, 9, false, 2, true, 0.5, ScanOrder.DESCENDING, 3, 4),
            law.withMinimumImpulse(9, false));
        assertEquals(new ImpactLaw(Restitution.ELASTIC, 1, true, 9, true, 0.5, ScanOrder.DESCENDING, 3, 4),
            law.withDeadZone(9));
        assertEquals(new ImpactLaw(Restitution.ELASTIC, 1, true, 2, true, 0.5, ScanOrder.DESCENDING, 9, 4),
            law.withPushOut(9));
        assertEquals(new ImpactLaw(Restitution.ELASTIC, 1, true, 2, true, 0.5, ScanOrder.DESCENDING, 3, 9),
            law.withMaximumImpacts(9));
    }

    /** The documented default, 10,000 + 1,000 per body. */
    @Test
    void theBoundOnImpacts() {
        assertEquals(14_000, ImpactLaw.PHYSICS.impactLimit(4));
        assertEquals(7, ImpactLaw.PHYSICS.withMaximumImpacts(7).impactLimit(4));
    }

    @Test
    void contactsThatAskNeedAReactionAndTheOtherWayRound() {
        Contacts asking = new Contacts(2).set(0, 1, Contacts.Meaning.ASK);
        refused("contacts ask, but there is no reaction", () -> parts(asking, null));
        refused("there is a reaction, but no contact asks",
            () -> parts(new Contacts(2), (time, a, b, bodies, sink) -> Reaction.Verdict.PASS));
        refused("0 kinds, expected at least 1", () -> new Contacts(0));
    }

    private static PhysicsParts parts(Contacts contacts, Reaction reaction) {
        return new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, contacts, List.of(), reaction, false);
    }

    @Test
    void contactsAreSymmetric() {
        Contacts contacts = new Contacts(3).set(2, 0, Contacts.Meaning.NONE).setWall(1, Contacts.Meaning.ASK);
        assertEquals(Contacts.Meaning.NONE, contacts.between(0, 2));
        assertEquals(Contacts.Meaning.NONE, contacts.between(2, 0));
        assertEquals(Contacts.Meaning.BOUNCE, contacts.between(1, 2));
        assertEquals(Contacts.Meaning.ASK, contacts.withWall(1));
        assertEquals(Contacts.Meaning.BOUNCE, contacts.withWall(0));
        assertEquals(true, contacts.containsAsk());
        assertEquals(false, contacts.allBounce());
        assertEquals(true, new Contacts(3).allBounce());
    }
}
