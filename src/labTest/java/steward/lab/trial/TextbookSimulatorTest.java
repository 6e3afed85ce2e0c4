package steward.lab.trial;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TextbookSimulator;
import steward.physics.TurnLog;
import steward.physics.event.EventAdvance;
import steward.physics.event.QueueAdvance;

/** The textbook's simulator and our forms on the same gas: the same impacts in the same order, until rounding parts. */
class TextbookSimulatorTest {

    private static final int IMPACTS = 80;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void allFormsHaveTheImpactsOfTheTextbook(long seed) {
        Gas gas = new Gas(seed, 30, 0.2);
        List<String> expected = new ArrayList<>();
        new TextbookSimulator(gas.bodies(), gas.side(), (time, a, b) -> expected.add(
            b < 0 ? a + " vertical" : a < 0 ? b + " horizontal" : Math.min(a, b) + " " + Math.max(a, b))).play(IMPACTS);
        for (Arithmetic arithmetic : Arithmetic.values()) {
            PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, new Contacts(1),
                List.of(gas.walls()), null, false);
            assertEquals(expected, impacts(new EventAdvance(parts), gas), "seed " + seed + ", pairs, " + arithmetic);
            assertEquals(expected, impacts(new QueueAdvance(parts), gas), "seed " + seed + ", crowd, " + arithmetic);
        }
    }

    private static List<String> impacts(Advance advance, Gas gas) {
        Bodies bodies = gas.bodies();
        List<String> seen = new ArrayList<>();
        while (seen.size() < IMPACTS) {
            TurnLog log = new TurnLog();
            advance.turn(bodies, log);
            for (int k = 0; k < log.impacts() && seen.size() < IMPACTS; k++) {
                Impact impact = log.impact(k);
                seen.add(impact.isWall() ? impact.a() + (impact.normalX() == 0 ? " horizontal" : " vertical")
                    : Math.min(impact.a(), impact.b()) + " " + Math.max(impact.a(), impact.b()));
            }
        }
        return seen;
    }
}
