package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.TimeBasis;
import steward.scene.Time;

/** Limits of one bot in place of the scene's. */
class OwnLimitsTest {

    private static final Time SCENE = new Time(1000, 75);

    @Test
    void limitsAreReadAsTheyAreWritten() {
        for (String text : new String[] {"60", "60,500", "3600000,1"}) {
            assertEquals(text, OwnLimits.parse(text).written());
        }
        assertEquals("answers within 60 ms", OwnLimits.parse("60").toString());
        assertEquals("answers within 60 ms, the first within 500 ms", OwnLimits.parse("60,500").toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "0", "-5", "60,", "60,0", ",60", "6e1", "60.5", "60 ", "60,500,1", "3600001",
        "60,3600001", "99999999999999999999", "\u0661"})
    void whatIsNoLimitIsRefusedWithWhatWasFound(String text) {
        assertEquals("found '" + text + "', expected whole numbers of milliseconds from 1 to 3600000 as MS[,FIRST]",
            assertThrows(IllegalArgumentException.class, () -> OwnLimits.parse(text)).getMessage());
    }

    @Test
    void theFirstAnswerHasTheScenesLimitUnlessThatIsLessThanForTheOthers() {
        assertEquals(new Time(1000, 60), OwnLimits.parse("60").in(SCENE));
        assertEquals(new Time(5000, 5000), OwnLimits.parse("5000").in(SCENE));
        assertEquals(new Time(500, 5000), OwnLimits.parse("5000,500").in(SCENE));
    }

    /** 60 ms times 2; the game's 9 ms times 2; the scene's 75 ms times 2. */
    @Test
    void aPlayersOwnLimitComesBeforeThatOfTheGameAndOfTheScene() {
        TimeControl time = TimeControl.of(SCENE, 2).by(TimeBasis.CPU);
        Time own = new Time(500, 60);
        assertEquals(1_000_000_000L, time.limit(own, 9, 0));
        assertEquals(120_000_000L, time.limit(own, 9, 1));
        assertEquals(18_000_000L, time.limit(null, 9, 1));
        assertEquals(150_000_000L, time.limit(null, 0, 1));
        assertEquals(2_000_000_000L, time.limit(null, 0, 0));
        assertEquals(Long.MAX_VALUE, TimeControl.UNLIMITED.limit(own, 9, 0));
    }
}
