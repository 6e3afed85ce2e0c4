package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import steward.replay.ReplayException;

/** The page as a file: what is in it, and what is refused. No browser is needed. */
class PageTestFiles {

    /** A full race of 500 turns, mailed around. */
    private static final int LARGEST = 1_500_000;

    private static String page(byte[] replay, String title) {
        return new String(ReplayPage.of(replay, "race.jsonl", title, PageExtras.NONE), StandardCharsets.UTF_8);
    }

    private static byte[] duel() {
        return PageTestRaces.play(PageTestRaces.scene("duel"), 5);
    }

    @Test
    void holdsTheReplayByteForByte() {
        byte[] replay = duel();
        assertArrayEquals(replay, PageTestPages.embedded(page(replay, "t")));
    }

    @Test
    void holdsAReplayThatWasCutOffUpToItsLastWholeLine() {
        byte[] replay = duel();
        byte[] cut = Arrays.copyOf(replay, replay.length / 2);
        String held = new String(PageTestPages.embedded(page(cut, "t")), StandardCharsets.UTF_8);
        assertTrue(held.endsWith("}\n"));
        assertTrue(new String(cut, StandardCharsets.UTF_8).startsWith(held));
    }

    @Test
    void isTheSameWrittenTwice() {
        byte[] replay = duel();
        assertEquals(page(replay, "t"), page(replay, "t"));
    }

    @Test
    void namesNoOtherPlace() {
        String page = page(duel(), "t");
        assertFalse(page.contains("http:") || page.contains("https:") || page.contains("//www"), "an address");
        assertTrue(page.contains("default-src 'none'") && page.contains("connect-src 'none'"));
        assertFalse(page.contains("{{"), "a place was not filled");
    }

    @Test
    void escapesTheTitle() {
        String page = page(duel(), "<b>\"A & B\"</b>");
        assertTrue(page.contains("<title>&lt;b&gt;&quot;A &amp; B&quot;&lt;/b&gt;</title>"));
        assertFalse(page.contains("<b>\"A"));
    }

    @Test
    void aRaceOfFiveHundredTurnsIsSmallEnoughToMail() {
        String scene = PageTestRaces.scene("mad-pod-racing").replace("\"laps\": 3", "\"laps\": 100");
        byte[] replay = PageTestRaces.play(scene, 11);
        assertEquals(500, PageTestRaces.lines(replay).size() - 2);
        int size = page(replay, "t").length();
        assertTrue(size < LARGEST, () -> size + " bytes");
    }

    @Test
    void refusesWhatIsNoReplay() {
        byte[] notes = "hello\n".getBytes(StandardCharsets.UTF_8);
        ReplayException problem = assertThrows(ReplayException.class,
            () -> ReplayPage.of(notes, "notes.txt", "t", PageExtras.NONE));
        assertTrue(problem.getMessage().startsWith("notes.txt:1"), problem.getMessage());
    }

    @Test
    void refusesANewerFormatAndADamagedReplay() {
        String text = new String(duel(), StandardCharsets.UTF_8);
        byte[] newer = text.replaceFirst("\"format\":\\d+", "\"format\":999").getBytes(StandardCharsets.UTF_8);
        assertTrue(assertThrows(ReplayException.class, () -> page(newer, "t")).getMessage().contains("999"));
        int middle = text.indexOf('\n', text.length() / 2) + 1;
        byte[] damaged = (text.substring(0, middle) + "{\n" + text.substring(middle)).getBytes(StandardCharsets.UTF_8);
        assertThrows(ReplayException.class, () -> page(damaged, "t"));
    }
}
