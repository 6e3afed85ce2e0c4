package steward.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

/** Events that a log keeps of a turn, and events that it only counts. */
class TurnLogTest {

    private static void impact(TurnLog log, int number) {
        log.impact(number, number, number + 1, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0);
    }

    /** A scene of 1 kB may ask for turns of a million impacts: they were all kept, 160 bytes each. */
    @Test
    void theFirstImpactsAreKeptAndAllAreCounted() {
        TurnLog log = new TurnLog(20);
        for (int turn = 0; turn < 2; turn++) {
            for (int k = 0; k < 1_000_000; k++) {
                impact(log, k);
            }
            assertEquals(1_000_000, log.impacts());
            assertEquals(20, log.kept());
            assertEquals(19, log.impact(19).time());
            assertThrows(IndexOutOfBoundsException.class, () -> log.impact(20));
            log.clear();
            assertEquals(0, log.impacts());
            assertEquals(0, log.kept());
        }
    }

    @Test
    void withoutANumberAllAreKept() {
        TurnLog log = new TurnLog();
        for (int k = 0; k < TurnLog.RECORDED + 1; k++) {
            impact(log, k);
        }
        assertEquals(TurnLog.RECORDED + 1, log.kept());
        assertEquals(TurnLog.RECORDED, log.impact(TurnLog.RECORDED).time());
        assertThrows(IllegalArgumentException.class, () -> new TurnLog(-1));
    }
}
