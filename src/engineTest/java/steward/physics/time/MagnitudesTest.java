package steward.physics.time;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.Refusal;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.QueueAdvance;
import steward.physics.event.Scenes;
import steward.physics.event.StepAdvance;

/** Numbers whose squares no double can hold: computed right, or refused by name. */
@Execution(ExecutionMode.CONCURRENT)
class MagnitudesTest {

    /*
     *      o ->   o        radius 1, gap 2, closing 4: they meet at t = 1/2; equal masses exchange their speeds
     */
    private static Bodies pair(double scale) {
        Bodies bodies = Scenes.bodies(new double[][] {{-4 * scale, 0, 4 * scale, 0, 1, scale}, {0, 0, 0, 0, 1, scale}});
        return bodies;
    }

    private static Advance advance(Arithmetic arithmetic, Wall... walls) {
        return new EventAdvance(
            new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, new Contacts(1), List.of(walls), null, false));
    }

    @ParameterizedTest
    @EnumSource
    void everySizeHasTheSameTurn(Arithmetic arithmetic) {
        for (int exponent = -1070; exponent <= 995; exponent++) {
            double scale = Math.scalb(1.0, exponent);
            Bodies bodies = pair(scale);
            TurnLog log = Scenes.turn(advance(arithmetic), bodies);
            assertEquals(1, log.impacts(), "2^" + exponent);
            assertEquals(0.5, log.impact(0).time(), "2^" + exponent);
            assertArrayEquals(new double[] {-2 * scale, 2 * scale, 0, 4 * scale},
                new double[] {bodies.x[0], bodies.x[1], bodies.vx[0], bodies.vx[1]}, "2^" + exponent);
        }
    }

    /** Twenty such pairs, far from each other, by the way for crowds. */
    @Test
    void everySizeHasTheSameTurnInACrowd() {
        PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, new Contacts(1), List.of(), null,
            false);
        for (int exponent = -1060; exponent <= 985; exponent += 5) {
            double scale = Math.scalb(1.0, exponent);
            Bodies bodies = new Bodies(40);
            for (int k = 0; k < 40; k++) {
                bodies.add((k % 2 == 0 ? -4 : 0) * scale, 16 * (k / 2) * scale, scale, 1);
                bodies.setVelocity(k, k % 2 == 0 ? 4 * scale : 0, 0);
            }
            TurnLog log = Scenes.turn(new QueueAdvance(parts), bodies);
            assertEquals(20, log.impacts(), "2^" + exponent);
            for (int k = 0; k < 40; k++) {
                assertEquals(0.5, log.impact(k / 2).time(), "2^" + exponent);
                assertEquals((k % 2 == 0 ? -2 : 2) * scale, bodies.x[k], "2^" + exponent + ", body " + k);
                assertEquals((k % 2 == 0 ? 0 : 4) * scale, bodies.vx[k], "2^" + exponent + ", body " + k);
            }
        }
    }

    @Test
    void whatIsOrdinary() {
        assertTrue(Magnitudes.fitPlainArithmetic(pair(1e59)) && Magnitudes.fitPlainArithmetic(pair(1e-60)));
        assertFalse(Magnitudes.fitPlainArithmetic(pair(1e61)) || Magnitudes.fitPlainArithmetic(pair(1e-61)));
        Bodies coasting = pair(1);
        coasting.setVelocity(0, 1e-210, 0);
        assertTrue(Magnitudes.fitPlainArithmetic(coasting), "slowed down by drag for 3,000 turns");
        coasting.setVelocity(0, 1e-212, 0);
        assertFalse(Magnitudes.fitPlainArithmetic(coasting));
        coasting.setVelocity(0, 1, 0);
        coasting.setMass(1, Double.POSITIVE_INFINITY);
        assertTrue(Magnitudes.fitPlainArithmetic(coasting));
        coasting.setMass(1, 1e-91);
        assertFalse(Magnitudes.fitPlainArithmetic(coasting));
        coasting.setMass(1, 1);
        coasting.vy[1] = Double.NaN;
        assertFalse(Magnitudes.fitPlainArithmetic(coasting));
    }

    @ParameterizedTest
    @CsvSource({
        "1e305, 0, 1, 1, 'body 0: x 1.0E305, expected a magnitude of at most 1.0715086071862673E301'",
        "0, 1e305, 1, 1, 'body 0: vx 1.0E305, expected a magnitude of at most 1.0715086071862673E301'",
        "0, 1, 1e305, 1, 'body 0: radius 1.0E305, expected a magnitude of at most 1.0715086071862673E301'",
        "0, 1e10, 1, 1e300, 'body 0: vx 1.0E10, expected a momentum of at most 1.1235582092889474E307 "
            + "(its mass is 1.0E300)'",
    })
    void whatCannotBeComputedIsRefused(double x, double vx, double radius, double mass, String message) {
        for (Arithmetic arithmetic : Arithmetic.values()) {
            Bodies bodies = Scenes.bodies(new double[][] {{x, 0, vx, 0, mass, radius}});
            Refusal.refused(message, () -> advance(arithmetic).turn(bodies, TurnSink.NONE));
            assertEquals(x, bodies.x[0], "nothing has moved");
        }
    }

    @Test
    void segmentsTakeOrdinaryLengthsOnly() {
        Refusal.refused("body 0: x -4.0E100, expected 0 or a magnitude of 6.223015277861142E-61..1.6069380442589903E60 "
            + "where walls are segments", () -> advance(Arithmetic.DOUBLE, new Segment(0, 0, 1, 1, 1))
                .turn(pair(1e100), TurnSink.NONE));
    }

    /** Steps refuse what event rungs refuse, and compute the others as these do. */
    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, 1e302, 1e300, -1e200, 1e-70})
    void stepsTreatNumbersOutOfRangeAsEventRungsDo(double value) {
        PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE);
        assertEquals(outcome(new EventAdvance(parts), value), outcome(new StepAdvance(parts, 4), value));
    }

    private static String outcome(Advance advance, double value) {
        Bodies bodies = Scenes.bodies(new double[][] {{0, 0, 0, 0, 1, 1}, {10, 0, 0, 0, 1, 1}});
        bodies.x[1] = value;
        bodies.vx[0] = 5;
        try {
            advance.turn(bodies, TurnSink.NONE);
            return bodies.x[0] + " " + bodies.x[1] + " " + bodies.vx[0];
        } catch (IllegalArgumentException refusal) {
            return refusal.getMessage();
        }
    }
}
