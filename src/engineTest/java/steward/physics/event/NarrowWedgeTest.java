package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.Wall;

/*
 * Along a wall and into it an impact makes (t, -e n) of (t, n), which for the other wall, at the angle w, is
 * (t cos w - e n sin w, t sin w + e n cos w): a matrix with the determinant e and the trace (1 + e) cos w. Its larger
 * eigenvalue is the share of the speed that an impact leaves in the end. It is real for cos w >= 2 sqrt(e) / (1 + e);
 * then the impacts have no end, until 2^-20 of the speed is left.
 */

/** Discs that fall into a wedge so narrow that their bounces have no end: as many as these lose, and no fewer. */
@Execution(ExecutionMode.CONCURRENT)
class NarrowWedgeTest {

    private static final double RESTITUTION = 0.5;

    /** A turn in which one disc falls, or a second above it falls, too. */
    private static TurnLog fall(Advance advance, double sin, boolean both) {
        Bodies bodies = Scenes.bodies(new double[][] {{1, 10 / sin + 20, 0, -200},
            {0.5, 10 / sin + 60, 0, both ? -200 : 0}});
        bodies.setRestitution(0, RESTITUTION);
        bodies.setRestitution(1, RESTITUTION);
        TurnLog log = Scenes.turn(advance, bodies);
        assertFalse(log.limited());
        return log;
    }

    @ParameterizedTest
    @CsvSource({"8, DOUBLE", "15, OFFICIAL", "15, DOUBLE", "15, COMPENSATED", "8, EXACT", "15, EXACT"})
    void eachBounceLeavesTheShareOfTheEigenvalueAndASecondDiscBeginsAnew(double degrees, Arithmetic arithmetic) {
        double half = StrictMath.toRadians(degrees / 2);
        double cos = StrictMath.cos(half);
        double sin = StrictMath.sin(half);
        double trace = (1 + RESTITUTION) * StrictMath.cos(2 * half);
        double share = (trace + Math.sqrt(trace * trace - 4 * RESTITUTION)) / 2;
        List<Wall> walls = List.of(new HalfPlane(0, 0, cos, sin, 1), new HalfPlane(0, 0, -cos, sin, 1));
        PhysicsParts parts = new PhysicsParts(Scenes.WITH_RESTITUTION, arithmetic, new Contacts(1), walls, null, false);
        for (Advance advance : Scenes.both(parts)) {
            TurnLog one = fall(advance, sin, false);
            int last = one.impacts() - 3;                                      // two more for the heap at rest
            assertEquals(share, one.impact(last).impulse() / one.impact(last - 1).impulse(), 1e-9);
            assertEquals(StrictMath.log(0x1p-20) / StrictMath.log(share), one.impacts(), 0.1 * one.impacts());
            TurnLog two = fall(advance, sin, true);
            assertTrue(two.impacts() > 4 * one.impacts(), two.impacts() + " of two, " + one.impacts() + " of one");
        }
    }
}
