package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.TurnSink;

/** Equal masses that meet centrally exchange their velocities, to the bit; ties go to the lowest pair. */
class CentralImpactTest {

    private static List<Advance> both(Arithmetic arithmetic) {
        PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, arithmetic);
        return Scenes.both(parts);
    }

    /** A pair whose distance is the sum of the radii but for a rounding: the first kept 3.85e-34 of its speed. */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void thePairThatKeptATraceOfItsSpeed(Arithmetic arithmetic) {
        for (Advance advance : both(arithmetic)) {
            Bodies bodies = Scenes.bodies(new double[][] {{876, 968, 0.21200439021358963, 0, 1, 437},
                {1552.9999999999998, 968, 0, 0, 1, 240}});
            advance.turn(bodies, TurnSink.NONE);
            assertEquals(0, bodies.vx[0]);
            assertEquals(0.21200439021358963, bodies.vx[1]);
        }
    }

    /** Along the diagonal, both coordinates alike: the direction has no representable unit vector. */
    @ParameterizedTest
    @EnumSource(value = Arithmetic.class, names = "EXACT")
    void alongTheDiagonalToo(Arithmetic arithmetic) {
        for (long seed = 1; seed <= 500; seed++) {
            SplitMix64 random = new SplitMix64(seed);
            for (Advance advance : both(arithmetic)) {
                Bodies bodies = new Bodies(2);
                double place = 100 + 100 * random.nextDouble();
                double speed = 100 + 100 * random.nextDouble();
                bodies.add(0, 0, 10 + random.nextDouble(), 1);
                bodies.add(place, place, 20 * random.nextDouble() + 1, 1);
                bodies.setVelocity(0, 2 * speed, 2 * speed);
                advance.turn(bodies, TurnSink.NONE);
                assertEquals(0, bodies.vx[0], "seed " + seed);
                assertEquals(0, bodies.vy[0], "seed " + seed);
                assertEquals(2 * speed, bodies.vx[1], "seed " + seed);
            }
        }
    }

    /**
     * The example of the README. Disc 1 passes on what it gets from 0, gets what 2 has, and passes that on.
     * <pre>
     *     0-->  1  <--2
     * </pre>
     */
    @ParameterizedTest
    @EnumSource(Arithmetic.class)
    void aDiscHitFromBothSidesAtOnceRests(Arithmetic arithmetic) {
        for (Advance advance : both(arithmetic)) {
            Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 40, 0}, {40, 0, 0, 0}, {80, 0, -40, 0}});
            TurnLog log = Scenes.turn(advance, bodies);
            assertEquals(3, log.impacts());
            for (int k = 0; k < 3; k++) {
                assertEquals(0.5, log.impact(k).time());
                assertEquals(k == 1 ? 1 : 0, log.impact(k).a());
                assertEquals(k == 1 ? 2 : 1, log.impact(k).b());
            }
            assertEquals(-40, bodies.vx[0]);
            assertEquals(0, bodies.vx[1]);
            assertEquals(40, bodies.vx[2]);
        }
    }
}
