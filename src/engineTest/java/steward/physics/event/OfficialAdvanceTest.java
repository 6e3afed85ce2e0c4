package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;

/** The loop made for the official law ends every turn as the loop made for every law: bodies, impacts, knots. */
@Execution(ExecutionMode.CONCURRENT)
class OfficialAdvanceTest {

    private static final ImpactLaw LAW = ImpactLaw.OFFICIAL_POD_RACE;
    private static final PhysicsParts PARTS = new PhysicsParts(LAW, Arithmetic.OFFICIAL, new Contacts(2), List.of(),
        null, false);
    private static final Advance GENERAL = new EventAdvance(PARTS);

    @ParameterizedTest
    @CsvSource({"0, 1, 400", "1, 1, 400", "2, 3000, 400", "4, 3000, 400", "4, 3000, 0.3", "4, 2000, 123.456",
        "11, 500, 400", "12, 100, 400"})
    void bodiesOfOneSizeEndAsInTheGeneralLoop(int bodies, int turns, double radius) {
        SplitMix64 random = new SplitMix64(bodies);
        Advance fast = new OfficialAdvance(PARTS);
        long impacts = 0;
        for (int turn = 0; turn < turns; turn++) {
            impacts += Scenes.assertSameTurn(GENERAL, fast, heap(random, bodies, radius),
                "seed " + bodies + ", turn " + turn);
        }
        assertTrue(bodies < 2 || impacts > turns / 4, impacts + " impacts");
    }

    /** Radii may change from turn to turn, and need not be the same. */
    @Test
    void bodiesOfOtherSizesDoToo() {
        SplitMix64 random = new SplitMix64(5);
        Advance fast = new OfficialAdvance(PARTS);
        long impacts = 0;
        for (int turn = 0; turn < 2000; turn++) {
            Bodies bodies = heap(random, 4, random.nextInt(100, 400));
            if (turn % 2 == 0) {
                bodies.setRadius(random.nextInt(4), random.nextInt(100, 800));
            }
            impacts += Scenes.assertSameTurn(GENERAL, fast, bodies, "seed 5, turn " + turn);
        }
        assertTrue(impacts > 500, impacts + " impacts");
    }

    @Test
    void numbersThatAreNotOrdinaryAreLeftToTheGeneralLoop() {
        Bodies bodies = heap(new SplitMix64(6), 4, 400);
        bodies.setVelocity(2, 1e160, 0);
        bodies.setPosition(3, 1e155, 1);
        assertTrue(Scenes.assertSameTurn(GENERAL, new OfficialAdvance(PARTS), bodies, "huge") > 0);
    }

    @Test
    void moreThanTheOfficialLawIsRefused() {
        PhysicsParts exact = new PhysicsParts(LAW, Arithmetic.EXACT);
        assertThrows(IllegalArgumentException.class, () -> new OfficialAdvance(exact));
        PhysicsParts walls = new PhysicsParts(LAW, Arithmetic.OFFICIAL, new Contacts(1),
            List.of(new HalfPlane(0, 0, 1, 0, 1)), null, false);
        assertThrows(IllegalArgumentException.class, () -> new OfficialAdvance(walls));
    }

    private static Bodies heap(SplitMix64 random, int count, double radius) {
        Bodies bodies = new Bodies(Math.max(1, count));
        double side = radius * (2 + count);
        for (int k = 0; k < count; k++) {
            bodies.add(side * random.nextDouble(), side * random.nextDouble(), radius, k % 3 == 0 ? 10 : 1);
            bodies.setKind(k, k % 2);
            bodies.setVelocity(k, 4 * radius * (random.nextDouble() - 0.5), 4 * radius * (random.nextDouble() - 0.5));
        }
        return bodies;
    }
}
