package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.physics.ImpactLaw;

class RungLawTest {

    /** The expected fingerprint is kept with the law. */
    @ParameterizedTest
    @EnumSource
    void whoChangesTheBitsOfALawGivesItTheNextVersion(RungLaw law) {
        assertEquals(law.fingerprint(), PhysicsFingerprint.of(law), law + ", version " + law.version()
            + ": if a turn was to change, its next version and then this fingerprint");
    }

    @ParameterizedTest
    @EnumSource
    void programsBeforeVersionsHadTheFirstLawOfEveryRung(RungLaw law) {
        assertEquals(law.version() == 1, law.key().equals(RungLaw.WHOLE_LADDER));
        assertEquals(law.version() == 1, law.key().equals(law.keyAmong(RungLaw.WHOLE_LADDER)));
    }

    @ParameterizedTest
    @EnumSource
    void aWorkerIsKnownByItsKeyOfTheLaw(RungLaw law) {
        assertEquals(law.key(), law.keyAmong(RungLaw.keys()));
        assertFalse(law.keyAmong("0123456789abcdef 0123456789abcdef").equals(law.key()));
    }

    /** Another law of a rung changes its own fingerprint and no other one. */
    @ParameterizedTest
    @ValueSource(strings = {"step/4", "event/official", "event/double", "event/compensated", "event/exact"})
    void figuresHoldWhileTheirLawIsTheOneThatWasMeasured(String name) {
        Accuracy rung = Accuracy.parse(name);
        for (ImpactLaw impacts : List.of(ImpactLaw.OFFICIAL_POD_RACE,
            ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM))) {
            RungLaw law = RungLaw.of(rung, impacts, false);
            assertTrue(RungLaw.holds(law.fingerprint(), rung, true, RungLaw::fingerprint));
            assertFalse(RungLaw.holds(law.fingerprint(), rung, true, any -> "of another law"));
            RungLaw withoutRest = RungLaw.of(rung, ImpactLaw.PHYSICS, false);
            assertFalse(RungLaw.holds(RungLaw.WHOLE_LADDER, rung, false, any -> any == withoutRest ? "another"
                : any.fingerprint()));
            assertEquals(withoutRest.version() == 1,
                RungLaw.holds(RungLaw.WHOLE_LADDER, rung, false, RungLaw::fingerprint));
            RungLaw withRest = RungLaw.of(rung, ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM),
                false);
            assertEquals(withoutRest.version() == 1 && withRest.version() == 1,
                RungLaw.holds(RungLaw.WHOLE_LADDER, rung, true, RungLaw::fingerprint));
        }
    }

    @ParameterizedTest
    @EnumSource
    void everyLawHasAFingerprintOfItsOwn(RungLaw law) {
        assertEquals(1, Arrays.stream(RungLaw.values())
            .filter(other -> other.fingerprint().equals(law.fingerprint())).count());
    }
}
