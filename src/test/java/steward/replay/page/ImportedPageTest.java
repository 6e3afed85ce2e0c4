package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import steward.codingame.recording.OfficialGame;
import steward.codingame.recording.RecordingImport;
import steward.codingame.recording.ServerMeanMax;
import steward.match.TestScenes;

/** The page of an imported match in a real browser. */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class ImportedPageTest {

    private static final int TURNS = 33;

    @TempDir
    private Path folder;

    @Test
    void everyTurnIsShownWithoutComplaint() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        RecordingImport.of(OfficialGame.play(12).sketch(TURNS), "game.json", TestScenes.TYPES).write(replay);
        Path page = new PageTestPages(folder).page(replay.toByteArray(), "Imported");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.open(page, "#turn=1");
            browser.run("steward.pause()");
            browser.draw(0, TURNS, 0.5);
            browser.seek(TURNS, 1);
            assertEquals(List.of(), browser.complaints());
            assertEquals(TURNS, browser.number("steward.lastTurn()"));
        }
    }

    @Test
    void fromTheFirstTurnThatDiffersBothLinesAreShown() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        String json = OfficialGame.play(12).json();
        String frame = "\"view\":\" 20\\n";
        RecordingImport.of(json.replace(frame, frame + "1"), "game.json", TestScenes.TYPES).write(replay);
        Path page = new PageTestPages(folder).page(replay.toByteArray(), "Imported", PageExtras.of(TestScenes.TYPES));
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.open(page, "#turn=9");
            browser.run("steward.pause()");
            browser.seek(9, 1);
            assertTrue(browser.is("document.getElementById('differs').hidden"));
            browser.seek(12, 1);
            String[] lines = browser.text("#differs").split("\n");
            assertEquals("The server's game differs from here on: turn 10, view line 1, word 0", lines[0]);
            String theirs = lines[1].replaceFirst("server: *", "");
            assertEquals(theirs.substring(1), lines[2].replaceFirst("here: *", "").substring(0, theirs.length() - 1));
            assertEquals(List.of(), browser.complaints());
        }
    }

    @Test
    @Tag("campaign")
    void aGameWithViewsOfItsOwnIsShownWithoutComplaint() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        RecordingImport.of(ServerMeanMax.play(5, TURNS).json(), "game.json", TestScenes.TYPES).write(replay);
        Path page = new PageTestPages(folder).page(replay.toByteArray(), "Imported");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.open(page, "#turn=1");
            browser.run("steward.pause()");
            browser.draw(0, TURNS, 0.75);
            assertEquals(List.of(), browser.complaints());
            assertEquals(TURNS, browser.number("steward.lastTurn()"));
        }
    }
}
