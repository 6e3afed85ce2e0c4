package steward.bot.hold;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.junit.jupiter.api.Test;
import steward.bot.accounting.TreeSample;
import steward.bot.accounting.TreeSample.ThreadTimes;

/** When a bot burns. Time and what it has used are numbers that a test sets. */
class WaitingMeterTest {

    private static final long MS = 1_000_000;

    private final WaitingMeter meter = new WaitingMeter();
    private long used;

    /** A sample so many milliseconds after the beginning, in a wait. */
    private void look(long wait, double ms) {
        meter.add(wait, new TreeSample(Math.round(ms * MS), true, 1, 0, Map.of(1L, new ThreadTimes(used, 0, 1, true)),
            0), -1);
    }

    @Test
    void itBurnsWhenTheWholeWindowWasSeenAndAQuarterOfAProcessorUsed() {
        look(1, 0);
        used = 25 * MS;
        look(1, 99);
        assertFalse(meter.burns(), "the window is 100 ms");
        used = 26 * MS;
        look(1, 100);
        assertTrue(meter.burns());
        assertEquals(0.26, meter.processors(), 1e-12);
    }

    @Test
    void aQuarterItselfIsAllowed() {
        look(1, 0);
        used = 25 * MS;
        look(1, 100);
        assertFalse(meter.burns());
    }

    /** Between two waits the bot was asked: what it used then is its own affair. */
    @Test
    void whatIsUsedBetweenTwoWaitsDoesNotCount() {
        for (int wait = 1; wait <= 10; wait++) {
            look(wait, 100 * wait);
            look(wait, 100 * wait + 40);
            used += 60 * MS;
        }
        assertEquals(0, meter.processors());
        assertFalse(meter.burns());
    }

    /** Of ten waits of 40 ms the last three are more than the window, of which the last two are enough. */
    @Test
    void onlyTheLastOfTheTimeIsJudged() {
        for (int wait = 1; wait <= 10; wait++) {
            look(wait, 100 * wait);
            used += wait <= 7 ? 40 * MS : 0;
            look(wait, 100 * wait + 40);
        }
        assertFalse(meter.burns());
        assertEquals(0, meter.processors());
    }

    /** 90 ms on two processors, 210 ms of rest: 0.6 on average, but looks every 20 ms see 100 ms of both kinds. */
    @Test
    void restsDoNotHideWhatWasUsedWithinTheWindow() {
        boolean burnt = false;
        for (int ms = 0; ms <= 300; ms += 20) {
            used = 2 * Math.min(ms, 90) * MS;
            look(1, ms);
            burnt |= meter.burns();
        }
        assertTrue(burnt);
        assertFalse(meter.burns(), "the last 100 ms are rest");
    }

    /** A control group counts also what nobody waits for. */
    @Test
    void theCountOfAControlGroupGoesBeforeTheSample() {
        Map<Long, ThreadTimes> asleep = Map.of(1L, new ThreadTimes(0, 0, 1, false));
        meter.add(1, new TreeSample(0, true, 1, 0, asleep, 0), 500 * MS);
        meter.add(1, new TreeSample(100 * MS, true, 1, 0, asleep, 0), 560 * MS);
        assertEquals(0.6, meter.processors(), 1e-12);
    }

    /** A bot beside which another is late may have been seen for a moment only. */
    @Test
    void aMomentIsEnoughForASuspect() {
        look(1, 0);
        used = 10 * MS;
        look(1, 10);
        assertFalse(meter.isSuspect());
        used = 20 * MS;
        look(1, 20);
        assertTrue(meter.isSuspect());
        assertFalse(meter.burns());
        meter.reset();
        assertFalse(meter.isSuspect());
    }
}
