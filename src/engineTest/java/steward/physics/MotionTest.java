package steward.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.physics.Motion.Of;
import steward.physics.Motion.Step;

/** Steps at the end of a turn: their effects, and their order. */
class MotionTest {

    private static Bodies one(double x, double vx, double drag) {
        Bodies bodies = new Bodies(1);
        int body = bodies.add(x, -x, 1, 1);
        bodies.setVelocity(body, vx, -vx);
        bodies.setDrag(body, drag);
        return bodies;
    }

    @ParameterizedTest
    @CsvSource({"0.5, 1", "1.5, 2", "2.4999, 2", "0.49999999999999994, 0", "4503599627370495.5, 4503599627370496",
        "4503599627370497, 4503599627370497", "0, 0", "-0.0, 0", "-0.4, 0"})
    void halvesAreRoundedAwayFromZero(double value, double rounded) {
        assertEquals(rounded, Motion.roundHalfAway(value));
        assertEquals(rounded == 0 ? 0.0 : -rounded, Motion.roundHalfAway(-value), "never -0.0");
    }

    /** floor(x + 0.5), the sum being a double: so 0.49999999999999994 becomes 1; never -0.0. */
    @ParameterizedTest
    @CsvSource({"0.49999999999999994, 1", "0.5, 1", "1.5, 2", "2.5, 3", "-0.5, 0", "-1.5, -1", "-2.5, -2", "-0.0, 0",
        "0, 0", "-0.49999999999999994, 0", "-0.25, 0", "0.4999, 0", "0x1p52, 0x1p52",
        "2251799813685248.5, 2251799813685249", "-2251799813685248.5, -2251799813685248",
        "0x1p53, 0x1p53", "15999.5, 16000", "-0x1p-1074, 0"})
    void halvesAreRoundedUp(String value, String rounded) {
        Bodies bodies = new Bodies(1);
        bodies.add(Double.parseDouble(value), Double.parseDouble(value), 1, 1);
        new Motion(false, true, true).endTurn(bodies);
        assertEquals(Double.parseDouble(rounded), bodies.x[0]);
        assertEquals(Double.parseDouble(rounded), bodies.y[0]);
    }

    /** Toward zero, never to -0.0. */
    @ParameterizedTest
    @CsvSource({"-0.0, 0", "0, 0", "0.9999999999999999, 0", "-0.9999999999999999, 0", "1, 1", "-1, -1",
        "1.9999999999999998, 1", "-1.9999999999999998, -1", "-4.9E-324, 0", "4.9E-324, 0",
        "4503599627370497, 4503599627370497", "-123.7, -123"})
    void speedsAreCut(double value, double cut) {
        Bodies bodies = one(0, value, 0);
        new Motion(false, true, true).endTurn(bodies);
        assertEquals(cut, bodies.vx[0]);
        assertEquals(cut == 0 ? 0.0 : -cut, bodies.vy[0]);
    }

    @ParameterizedTest
    @CsvSource({"0.9999, 0", "0.999991, 1", "1.000009, 1", "1.5, 1", "-0.5, 0", "-1.999995, -2", "-1.99, -1", "7, 7"})
    void truncationSnapsToTheWholeNumberNextToIt(double value, double truncated) {
        assertEquals(truncated, Motion.truncateWithSnap(value));
    }

    /** Drag before rounding: 10.5 * 0.5 = 5.25; rounded first it would be 5.5 to 6. */
    @Test
    void stepsApplyInTheirOrder() {
        Bodies dragFirst = one(0, 10.5, 0.5);
        new Motion(List.of(Step.DRAG, Step.ROUND_VELOCITY)).endTurn(dragFirst);
        Bodies roundFirst = one(0, 10.5, 0.5);
        new Motion(List.of(Step.ROUND_VELOCITY, Step.DRAG)).endTurn(roundFirst);

        assertEquals(List.of(5.0, -5.0), List.of(dragFirst.vx[0], dragFirst.vy[0]));
        assertEquals(List.of(5.5, -5.5), List.of(roundFirst.vx[0], roundFirst.vy[0]));
    }

    @Test
    void positionsAreRoundedUpOrAway() {
        Bodies up = one(2.5, 0, 0);
        new Motion(false, false, true).endTurn(up);
        Bodies away = one(2.5, 0, 0);
        new Motion(List.of(Step.ROUND_POSITION_AWAY)).endTurn(away);

        assertEquals(List.of(3.0, -2.0), List.of(up.x[0], up.y[0]));
        assertEquals(List.of(3.0, -3.0), List.of(away.x[0], away.y[0]));
    }

    @Test
    void itSaysWhatItConsistsOf() {
        Motion motion = new Motion(List.of(Step.SNAP_POSITION, Step.DRAG, Step.SNAP_VELOCITY));

        assertTrue(motion.drag() && motion.endsInWholeNumbers());
        assertEquals(Step.SNAP_POSITION, motion.step(Of.POSITION));
        assertEquals(new Motion(List.of(Step.SNAP_POSITION, Step.SNAP_VELOCITY)), motion.only(Of.VELOCITY,
            Of.POSITION));
        assertNotEquals(new Motion(List.of(Step.DRAG, Step.SNAP_POSITION, Step.SNAP_VELOCITY)), motion);
        assertFalse(new Motion(true, true, false).endsInWholeNumbers());
        assertNull(new Motion(List.of()).step(Of.DRAG));
    }
}
