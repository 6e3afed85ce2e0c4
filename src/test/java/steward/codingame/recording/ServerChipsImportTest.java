package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.replay.verify.Verification;

/**
 * The Poker Chip Race as the site's server shows it. The excerpt is the beginning of a real game, published by
 * nmahoude/codingame: three turns in which all wait, and one with a push and a meal.
 */
class ServerChipsImportTest {

    private static String changed(String from, String to) throws IOException {
        String json = SiteGames.of("poker-chip-race");
        int at = json.lastIndexOf(from);
        assertTrue(at >= 0, "there is no " + from);
        return json.substring(0, at) + to + json.substring(at + from.length());
    }

    @Test
    void theExcerptVerifies() throws IOException {
        Verification found = ImportedRecording.verified(SiteGames.of("poker-chip-race"));
        assertNull(found.difference());
        assertEquals(4, found.states());
    }

    /** The last view that holds the text is that of turn 4. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "21.00 711.13 | 21.00 711.14 | view line 3, word 3",
        "711.13 206.10 | 711.13 206.11 | view line 3, word 4",
        "1 21.00 711.13 | 1 21.01 711.13 | view line 3, word 2",
        "2 -1 15.41 200.37 | 2 1 15.41 200.37 | view line 4, word 1",
        "375.41 155.10 0.00 0 | 375.41 155.10 0.00 | view line 6, word 6",
        "2 -1 15.41 200.37 | 2 7 15.41 200.37 | view line 4, word 1",
        "1385 1385\\n\" | 1385 1386\\n\" | view line 9, word 1"})
    void aChangedValueIsFound(String from, String to, String field) throws IOException {
        Verification found = ImportedRecording.verified(changed(from.strip(), to.strip()));
        assertNotNull(found.difference());
        assertEquals(field, found.difference().field());
        assertEquals(4, found.difference().turn());
    }

    @Test
    void aChangedPlaceOfTheStartIsFound() throws IOException {
        String json = SiteGames.of("poker-chip-race");
        Verification found = ImportedRecording.verified(json.replaceFirst("359\\.68 27\\.89", "359.69 27.89"));
        assertEquals(0, found.difference().turn());
        assertEquals("view line 4, word 3", found.difference().field());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "seed=603873261\\n | sneed=1\\n | refereeInput: found \"sneed=1\", expected seed=NUMBER or a setting",
        "seed=603873261\\n | symmetric=false\\n | refereeInput: found \"symmetric=false",
        "2 800 515 300 | 2 800 515 | frame 0, view line 2: found \"2 800 515\", expected players, width"})
    void whatIsWrongIsToldWithItsPlace(String from, String to, String expected) throws IOException {
        String problem = ImportedRecording.problem(changed(from, to));
        assertTrue(problem.startsWith("game.json: " + expected), problem);
    }
}
