package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.codingame.recording.OfficialGame;
import steward.codingame.recording.RecordingImport;
import steward.codingame.recording.ServerMeanMax;
import steward.match.TestScenes;

/** The page of an imported match in a real browser. */
class ImportedPageTest extends PageTestCase {

    private static final int TURNS = 33;

    @Test
    void everyTurnIsShownWithoutComplaint() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        RecordingImport.of(OfficialGame.play(12).sketch(TURNS), "game.json", TestScenes.TYPES, null).write(replay);
        Path page = pages.page(replay.toByteArray(), "Imported");
        browser.open(page, "#turn=1");
        browser.draw(0, TURNS, 0.5);
        browser.seek(TURNS, 1);
        assertEquals(TURNS, browser.number("steward.lastTurn()"));
    }

    @Test
    void fromTheFirstTurnThatDiffersBothLinesAreShown() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        String json = OfficialGame.play(12).json();
        String frame = "\"view\":\" 20\\n";
        RecordingImport.of(json.replace(frame, frame + "1"), "game.json", TestScenes.TYPES, null).write(replay);
        Path page = pages.page(replay.toByteArray(), "Imported", PageExtras.of(TestScenes.TYPES));
        browser.open(page, "#turn=9");
        browser.seek(9, 1);
        assertTrue(browser.is("document.getElementById('differs').hidden"));
        browser.seek(12, 1);
        String[] lines = browser.text("#differs").split("\n");
        assertEquals("The server's game differs from here on: turn 10, view line 1, word 0", lines[0]);
        String theirs = lines[1].replaceFirst("server: *", "");
        assertEquals(theirs.substring(1), lines[2].replaceFirst("here: *", "").substring(0, theirs.length() - 1));
    }

    @Test
    @Tag("campaign")
    void aGameWithViewsOfItsOwnIsShownWithoutComplaint() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        RecordingImport.of(ServerMeanMax.play(5, TURNS).json(), "game.json", TestScenes.TYPES, null).write(replay);
        Path page = pages.page(replay.toByteArray(), "Imported");
        browser.open(page, "#turn=1");
        browser.draw(0, TURNS, 0.75);
        assertEquals(TURNS, browser.number("steward.lastTurn()"));
    }
}
