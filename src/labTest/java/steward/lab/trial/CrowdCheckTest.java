package steward.lab.trial;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.lab.stability.crowds.CrowdCase;
import steward.lab.timing.WorkClock;
import steward.match.TestSize;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.event.QueueAdvance;
import steward.physics.event.StepAdvance;

/** Crowds in a box: no impact is missed, no body escapes at any coverage; boxes that hold no such crowd are refused. */
@Execution(ExecutionMode.CONCURRENT)
class CrowdCheckTest {

    @ParameterizedTest
    @Tag("slow")
    @CsvSource({"10, 0.001, 5000, DOUBLE", "10, 0.1, 20000, EXACT", "100, 0.1, 50000, COMPENSATED",
        "100, 0.6, 50000, DOUBLE", "200, 0.8, 20000, OFFICIAL", "150, 0.78, 5000, EXACT", "200, 0.78, 10000, DOUBLE",
        "5000, 0.01, 20000, DOUBLE", "10000, 0.1, 10000, DOUBLE"})
    @Tag("sized")
    void nothingIsMissed(int bodies, double coverage, long impacts, Arithmetic arithmetic) {
        assertNothingIsMissed(bodies, coverage, impacts / TestSize.of(4, 1), arithmetic);
    }

    @ParameterizedTest
    @Tag("campaign")
    @CsvSource({"1000, 0.8, 50000, OFFICIAL", "2000, 0.85, 10000, EXACT", "3000, 0.85, 20000, DOUBLE",
        "20000, 0.1, 25000, DOUBLE"})
    void nothingIsMissedInLargeCrowds(int bodies, double coverage, long impacts, Arithmetic arithmetic) {
        assertNothingIsMissed(bodies, coverage, impacts, arithmetic);
    }

    private static void assertNothingIsMissed(int bodies, double coverage, long impacts, Arithmetic arithmetic) {
        CrowdCheck.Result seen = CrowdCheck.run(new Gas(5, bodies, coverage), rung(arithmetic), impacts);
        assertTrue(seen.isRight() && seen.impacts() >= impacts && seen.drift() < 1e-10, seen::toString);
    }

    /** The check itself must see what is wrong: here discs that begin too near each other, and one outside. */
    @Test
    void theCheckSeesOverlapsAndEscapes() {
        Gas gas = new Gas(5, 50, 0.1);
        Bodies bodies = gas.bodies();
        bodies.setPosition(7, bodies.x[8] + 1.5, bodies.y[8]);
        bodies.setVelocity(7, 0, 0);
        bodies.setVelocity(8, 0, 0);
        bodies.setPosition(20, -3, 5);
        bodies.setVelocity(20, 0, 0);
        CrowdCheck.Result seen = CrowdCheck.run(bodies, gas, rung(Arithmetic.DOUBLE), 1);
        assertTrue(seen.overlaps() > 0 || seen.apart() > 0, seen::toString);
        assertTrue(seen.escapes() > 0, seen::toString);
    }

    /** Counted, not timed: all arrays together, at sizes at and next to powers of two. */
    @ParameterizedTest
    @CsvSource({"100, 0.1, EXACT", "129, 0.1, EXACT", "200, 0.01, EXACT", "100, 0.7, EXACT", "1000, 0.1, DOUBLE",
        "1000, 0.1, EXACT", "1023, 0.5, EXACT", "1025, 0.001, COMPENSATED",
        "1025, 0.001, EXACT", "4097, 0.1, DOUBLE"})
    @Tag("slow")
    void aBodyTakesFewBytes(int bodies, double coverage, Arithmetic arithmetic) {
        assertFewBytes(bodies, coverage, arithmetic);
    }

    @ParameterizedTest
    @Tag("campaign")
    @CsvSource({"4097, 0.1, EXACT", "8193, 0.3, EXACT"})
    void aBodyOfALargeCrowdTakesFewBytes(int bodies, double coverage, Arithmetic arithmetic) {
        assertFewBytes(bodies, coverage, arithmetic);
    }

    /** The first turn of an advance allocates its arrays; what it computes allocates as much in the second. */
    private static void assertFewBytes(int bodies, double coverage, Arithmetic arithmetic) {
        Gas gas = new Gas(1, bodies, coverage);
        PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, new Contacts(1), List.of(gas.walls()),
            null, false);
        QueueAdvance advance = new QueueAdvance(parts);
        allocated(new QueueAdvance(parts), gas.bodies());
        double first = allocated(advance, gas.bodies());
        double bytes = (first - allocated(advance, gas.bodies())) / bodies;
        assertTrue(bytes > 64, bytes + " bytes a body");
        assertTrue(bytes <= 240, bytes + " bytes a body");
    }

    private static double allocated(QueueAdvance advance, Bodies bodies) {
        double before = WorkClock.THREAD.bytes();
        advance.turn(bodies, TurnSink.NONE);
        return WorkClock.THREAD.bytes() - before;
    }

    /** The rows of the stability table fail where discs fly through each other, and where impacts are invented. */
    @Test
    void theCaseFailsOnAWrongAdvance() {
        Rung real = rung(Arithmetic.DOUBLE);
        StabilityCase crowd = new CrowdCase(100, 0.1, 0);
        assertEquals(Finding.Verdict.HOLDS, crowd.run(real, RunLength.SMALL).verdict());
        Rung steps = new Rung("steps", true, false, Arithmetic.DOUBLE, parts -> new StepAdvance(parts, 4));
        assertEquals(Finding.Verdict.FAILS, crowd.run(steps, RunLength.SMALL).verdict());
    }

    private static Rung rung(Arithmetic arithmetic) {
        return Rung.all().stream().filter(each -> each.isEvent() && each.arithmetic() == arithmetic).findFirst()
            .orElseThrow();
    }

    @Test
    void boxesThatHoldNoSuchCrowdAreRefused() {
        assertEquals("bodies 0, expected 1..10000000", refusal(0, 0.1));
        assertEquals("coverage 0.95, expected above 0 and at most 0.88", refusal(100, 0.95));
        assertEquals("coverage NaN, expected above 0 and at most 0.88", refusal(100, Double.NaN));
        assertEquals("bodies 10 at coverage 0.8: a box of 6.27 radii a side does not hold so many, expected 6 at most, "
            + "or a lower coverage", refusal(10, 0.8));
    }

    private static String refusal(int bodies, double coverage) {
        return assertThrows(IllegalArgumentException.class, () -> new Gas(1, bodies, coverage)).getMessage();
    }
}
