package steward.lab.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;

/** How long the rows of the stability table take. */
class StabilitySecondsTest {

    private static final StabilitySeconds TABLE = StabilitySeconds.read();

    @Test
    void everyRowIsInTheTable() {
        for (StabilityCase each : StabilityCases.all()) {
            for (Rung rung : Rung.all()) {
                assertTrue(TABLE.knows(each.name(), rung.name()), each.name() + ", " + rung.name());
                assertTrue(TABLE.of(each.name(), rung.name(), RunLength.SMALL, 0) > 0);
            }
        }
    }

    /** A crowd of a million impacts is the normal version. */
    @Test
    void aCrowdTakesAsLongAsItHasImpacts() {
        String crowd = "crowd of 1000, 10%";
        double normal = TABLE.of(crowd, "exact", RunLength.NORMAL, 0);
        assertEquals(normal, TABLE.of(crowd, "exact", RunLength.LONG, 1_000_000));
        assertEquals(1000 * normal, TABLE.of(crowd, "exact", RunLength.NORMAL, 1_000_000_000));
        assertEquals(TABLE.of("rounding", "exact", RunLength.NORMAL, 0),
            TABLE.of("rounding", "exact", RunLength.NORMAL, 1_000_000_000));
    }
}
