package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.TimeBasis;
import steward.scene.Time;

/** Limits: the scene's milliseconds times a factor. */
class TimeControlTest {

    @Test
    void theFirstAnswerAndTheOthers() {
        TimeControl time = TimeControl.of(new Time(1000, 75), 1);

        assertEquals(1_000_000_000L, time.limit(0));
        assertEquals(75_000_000L, time.limit(1));
        assertEquals(75_000_000L, time.limit(499));
    }

    /** A game with a limit of 50 ms counts 80 ms of the 100 ms that a player has as 40, and none without limits. */
    @Test
    void aGameCountsTimesAsIfTheLimitWereItsOwn() {
        assertEquals(40_000_000L, TimeControl.counted(80_000_000L, 100_000_000L, 50));
        assertEquals(49_999_999L, TimeControl.counted(49_999_999L, 50_000_000L, 50));
        assertEquals(0, TimeControl.counted(80_000_000L, Long.MAX_VALUE, 50));
        assertEquals(80_000_000L, TimeControl.counted(80_000_000L, 100_000_000L, 0));
        assertEquals(80_000_000L, TimeControl.allowed(40, 100_000_000L, 50));
        assertEquals(Long.MAX_VALUE, TimeControl.allowed(40, Long.MAX_VALUE, 50));
    }

    @Test
    void aFactorScalesBoth() {
        assertEquals(new TimeControl(500_000_000L, 37_500_000L, TimeBasis.WALL, 0.5),
            TimeControl.of(new Time(1000, 75), 0.5));
        assertEquals(25_000_000L, TimeControl.of(new Time(1000, 75), 0.5).limit(null, 50, 1));
    }

    @Test
    void aHugeFactorIsNoDeadlineInsteadOfAnOverflow() {
        TimeControl huge = TimeControl.of(new Time(1000, 75), 1e300);
        assertEquals(Long.MAX_VALUE, huge.limit(0));
        assertEquals(Long.MAX_VALUE, huge.limit(1));
        assertEquals(Long.MAX_VALUE, huge.limit(null, 75, 1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void otherFactorsAreRefused(double factor) {
        Time time = new Time(1000, 75);

        IllegalArgumentException refusal =
            assertThrows(IllegalArgumentException.class, () -> TimeControl.of(time, factor));

        assertEquals("time factor " + factor + ", expected above 0", refusal.getMessage());
    }
}
