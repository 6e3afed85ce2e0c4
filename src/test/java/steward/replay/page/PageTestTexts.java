package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;

/** Texts of players, files and callers, shown in a real browser: always harmless, never too much. */
class PageTestTexts extends PageTestCase {

    private static final String ATTACK = "</script><script>window.hacked = 1</script>"
        + "<img src=x onerror='window.hacked = 1'><!-- <script>";

    private static byte[] replay;

    @BeforeAll
    static void start() {
        replay = PageTestRaces.play(PageTestRaces.scene("duel"), 5);
    }

    private static void assertHarmless() {
        assertFalse(browser.is("window.hacked"));
        assertEquals(List.of(), browser.complaints());
        assertEquals(List.of(), browser.requests());
    }

    @Test
    void markupInAMessageIsText() {
        browser.open(pages.page(PageTestPages.withMessage(replay, ATTACK), "t"), "#turn=3");
        assertEquals(ATTACK, browser.text("#cards .message"));
        assertHarmless();
    }

    @Test
    void markupInStderrIsText() {
        browser.open(pages.page(PageTestPages.withStderr(replay, "@text 1 1 " + ATTACK + "\n" + ATTACK), "t"),
            "#turn=3");
        assertEquals(ATTACK, browser.text("#cards .stderr"));
        assertHarmless();
    }

    @Test
    void markupInNamesAndTitleIsText() {
        byte[] named = PageTestRaces.play(PageTestRaces.scene("duel"), 5, List.of(ATTACK, "{{script}}"));
        browser.open(pages.page(named, "\"" + ATTACK + "&amp;{{style}}"), "");
        assertEquals("\"" + ATTACK + "&amp;{{style}}", browser.text("h1"));
        assertTrue(browser.text("#scores").contains("</script><script>"), browser.text("#scores"));
        assertTrue(browser.text("#scores").contains("{{script}}"));
        assertHarmless();
    }

    @Test
    void tenThousandEmojiAreShownInPart() {
        browser.open(pages.page(PageTestPages.withMessage(replay, "😀".repeat(10_000)), "t"), "#turn=3");
        String shown = browser.text("#cards .message");
        assertTrue(shown.startsWith("😀😀") && shown.length() < 1000, () -> shown.length() + " characters");
        assertFalse(shown.contains("\ufffd"));
        assertTrue(shown.contains("19440 more"), shown);
        assertTrue(browser.is("document.documentElement.scrollWidth <= innerWidth"));
        assertHarmless();
    }

    @Test
    void drawsWhatABotAsksForOnItsTurn() {
        String stderr = "@line 5000 8000 11000 8000 #ff00ff\n@circle 8000 1000 300 lime\n@text 8000 1000 hello";
        browser.open(pages.page(PageTestPages.withStderr(replay, stderr), "t"), "#turn=3");
        assertTrue(pixel(8000, 8000).matches("255,0,255"), pixel(8000, 8000));
        assertTrue(pixel(8300, 1000).matches("0,255,0"), pixel(8300, 1000));
        assertTrue(browser.is("document.querySelector('#cards .stderr').hidden"), "good drawings are no text");
        browser.seek(0, 1);
        assertFalse(pixel(8000, 8000).matches("255,0,255"));
    }

    @Test
    void badDrawingsAreShownAsText() {
        List<String> bad = List.of("@line 1 2 3 red", "@line 1 2 3 4 red blue", "@circle 1 2 -3 red", "@circle a b c",
            "@line 1 2 3 NaN red", "@line 1 2 3 Infinity", "@text 5", "@circle 1 2 3 url(http://localhost/)",
            "@circle 1 2 3 notacolour", "@arrow 1 2 3 4", "@constructor 1 2", "@line 1e300 0 0 0 red",
            "@circle 1 2 3 inherit", "@circle 1 2 3 revert", "@circle 1 2 3 revert-layer", "@circle 0x10 2 3 red");
        browser.open(pages.page(PageTestPages.withStderr(replay, String.join("\n", bad)), "t"), "#turn=3");
        assertEquals(bad, browser.text("#cards .stderr").lines().toList());
        assertHarmless();
    }

    @Test
    void drawsAtMostTwoHundredShapesATurn() {
        browser.open(pages.page(PageTestPages.withStderr(replay, "@circle 1 2 3 red\n".repeat(250)), "t"), "#turn=3");
        assertTrue(browser.text("#cards .stderr").startsWith("(50 more drawings left out"),
            browser.text("#cards .stderr"));
    }

    /** Cut in the middle of a line: the turns before it are there, and the page says where it ends. */
    @Test
    void aReplayThatWasCutOffShowsWhatThereIs() {
        byte[] cut = Arrays.copyOf(replay, replay.length / 2);
        int turns = (int) new String(cut, StandardCharsets.UTF_8).chars().filter(c -> c == '\n').count() - 1;
        browser.open(pages.page(cut, "t"), "");
        String notice = browser.text("#notice");
        assertTrue(notice.matches("This recording was cut off within the line .*\\d+\\."), notice);
        browser.seek(turns, 1);
        assertEquals(turns, browser.number("steward.time()"));
        assertEquals(turns, browser.number("steward.lastTurn()"));
        assertTrue(browser.is("document.getElementById('ending').hidden"), "there is no result");
        assertHarmless();
    }

    @Test
    void aReplayCutOffBetweenLinesOrInItsHeaderSaysSo() {
        String text = new String(replay, StandardCharsets.UTF_8);
        byte[] header = text.substring(0, text.indexOf('\n') + 1).getBytes(StandardCharsets.UTF_8);
        browser.open(pages.page(header, "t"), "#turn=57");
        assertTrue(browser.text("#notice").contains("cut off before the first turn"), browser.text("#notice"));
        assertEquals(0, browser.number("steward.lastTurn()"));
        assertHarmless();
        browser.open(pages.page(Arrays.copyOf(replay, 200), "t"), "");
        assertTrue(browser.text("#notice").contains("cut off within the header"), browser.text("#notice"));
        assertHarmless();
    }

    /** Cut exactly before a line end: that turn is complete, as the reader says. */
    @Test
    void aReplayThatWasCutOffBeforeALineEndKeepsItsLastTurn() {
        String text = new String(replay, StandardCharsets.UTF_8);
        List<String> lines = text.lines().toList();
        browser.open(pages.page(String.join("\n", lines.subList(0, 6)).getBytes(StandardCharsets.UTF_8), "t"), "");
        assertTrue(browser.text("#notice").contains("cut off after turn 5"), browser.text("#notice"));
        assertEquals(5, browser.number("steward.lastTurn()"));
        browser.open(pages.page(lines.get(0).getBytes(StandardCharsets.UTF_8), "t"), "");
        assertTrue(browser.text("#scores").contains("steady"), "the header is complete");
        assertHarmless();
    }

    /** The aim is to open within 2 seconds; how long it takes is reported, for it depends on the machine. */
    @Test
    @Tag("campaign")
    void aRaceOfFiveHundredTurnsOpensAndScrubsToAnyTurn(TestReporter report) throws Exception {
        String scene = PageTestRaces.scene("mad-pod-racing").replace("\"laps\": 3", "\"laps\": 100");
        byte[] race = PageTestRaces.play(scene, 11);
        var lines = PageTestRaces.lines(race);
        assertEquals(502, lines.size());
        Path page = pages.page(race, "Long");
        long start = System.nanoTime();
        browser.open(page, "#turn=250");
        report.publishEntry(String.format("a race of 500 turns: %d bytes of replay, %d bytes of page, opened in %d ms",
            race.length, Files.size(page), (System.nanoTime() - start) / 1_000_000));
        for (int turn : new int[] {250, 1, 500, 57, 499, 123}) {
            browser.seek(turn, 1);
            browser.await("turn " + turn + " is not shown", () -> browser.text("#turn-shown").equals("Turn " + turn));
            String table = browser.text("#state");
            var outcome = lines.get(turn).get("outcome");
            assertTrue(table.contains(outcome.get("hash").asString()), table);
            for (var body : outcome.get("state").get("bodies")) {
                assertTrue(table.contains(body.get("x").asString()), table);
                assertTrue(table.contains(body.get("vy").asString()), table);
            }
        }
        assertHarmless();
    }

    /** The colour at a place of the field: red, green, blue. */
    private static String pixel(double x, double y) {
        return (String) browser.run("""
            const [x, y] = arguments;
            const canvas = document.getElementById('field');
            const { left, top } = canvas.getBoundingClientRect();
            const field = steward.field();
            const atX = field.left + (field.right - field.left) * x / 16000 - left;
            const atY = field.top + (field.bottom - field.top) * y / 9000 - top;
            const pixels = canvas.getContext('2d').getImageData(Math.round(atX) - 2, Math.round(atY) - 2, 5, 5).data;
            const rest = k => 255 * 3 - Math.max(...pixels.slice(k, k + 3)) + Math.min(...pixels.slice(k, k + 3));
            let best = 0;
            for (let k = 4; k < pixels.length; k += 4) if (rest(k) < rest(best)) best = k;
            return [...pixels.slice(best, best + 3)].map(value => (value > 200 ? 255 : value < 60 ? 0 : value)).join();
            """, x, y);
    }
}
