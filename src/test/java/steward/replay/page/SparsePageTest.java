package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** A sparse replay in a real browser: 4,001 bodies, so that each third state is kept, and the last. */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class SparsePageTest {

    private static final String SCENE = """
        { "name": "many", "game": "bodies", "players": 0, "field": { "width": 3000, "height": 3000 },
          "bodies": { "listed": [ { "x": 10, "y": 10, "vx": 1, "radius": 5 } ],
            "fill": { "shape": "lattice", "count": 4000, "radius": 10,
              "in": { "x": 50, "y": 50, "width": 2900, "height": 2900 } } },
          "play": { "maximumTurns": 4 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    @TempDir
    static Path folder;

    @Test
    void ofATurnWithoutStateOnlyPlacesAreShown() {
        Recorded match = Recorded.of(TestScenes.TYPES.open(SCENE, "many.json"), 7, List.of());
        Path page = new PageTestPages(folder).page(match.bytes(), "Many");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.size(1280, 720);
            browser.open(page, "");
            browser.run("steward.pause()");
            browser.run("steward.seek(2)");
            assertEquals("places at 2.00, straight from turn 0 to 3: the state of turn 2 was left out",
                browser.text("#state-when"));
            assertTrue(state(browser).startsWith("idxy01210"), state(browser).substring(0, 40));
            browser.run("steward.seek(3)");
            assertEquals("at the end of turn 3", browser.text("#state-when"));
            assertTrue(state(browser).startsWith("idxyvxvy0131010"), state(browser).substring(0, 40));
            assertEquals(List.of(), browser.complaints());
        }
    }

    private static String state(PageTestBrowser browser) {
        return (String) browser.run("return document.querySelector('#state').textContent");
    }
}
