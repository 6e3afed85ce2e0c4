package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.Cli;
import steward.cli.Recorded;
import steward.cli.shared.ExitStatus;
import tools.jackson.databind.JsonNode;

/** {@code steward replay --json}: one object, whatever is asked. */
class ReplayJsonTest {

    @TempDir
    private Path folder;
    private final Recorded duel = Recorded.duel(3);
    private Path file;

    @BeforeEach
    void write() throws IOException {
        file = Files.write(folder.resolve("x.jsonl"), duel.bytes());
    }

    private Cli replay(String... options) {
        String[] words = new String[options.length + 3];
        words[0] = "replay";
        words[1] = file.toString();
        words[2] = "--json";
        System.arraycopy(options, 0, words, 3, options.length);
        return Cli.run(words);
    }

    @Test
    void theSummary() {
        JsonNode json = replay().json();
        assertEquals("duel", json.get("scene").stringValue());
        assertEquals("3", json.get("seed").stringValue());
        assertEquals(duel.result().turns(), json.get("turns").intValue());
        assertEquals(duel.result().ending(), json.get("ending").stringValue());
        assertEquals(duel.result().winner(), json.get("winner").isNull() ? -1 : json.get("winner").intValue());
        assertEquals("pilot-1", json.get("players").get(1).get("name").stringValue());
        assertTrue(json.get("warning").isNull());
    }

    @Test
    void oneTurnAsItWasRecorded() {
        JsonNode json = replay("--turn", "2").json();
        assertEquals(2, json.get("turn").intValue());
        assertEquals(120, json.get("commands").get(0).get(0).get("thrust").intValue());
        assertEquals("t2", json.get("messages").get(1).stringValue());
        assertTrue(json.get("outcome").get("state").get("bodies").get(0).has("heading"));
        assertEquals(ExitStatus.UNUSABLE, replay("--turn", "900").status());
        assertEquals("", replay("--turn", "900").out());
    }

    @Test
    void theImpacts() {
        int impacts = 0;
        for (JsonNode turn : replay("--impacts").json().get("turns")) {
            impacts += turn.get("impacts").size();
            assertTrue(turn.get("impacts").get(0).get("impulse").doubleValue() > 0);
        }
        assertEquals(new String(duel.bytes(), StandardCharsets.UTF_8).split("\"impulse\":", -1).length - 1, impacts);
        assertEquals(impacts, replay().json().get("impacts").intValue());
        assertEquals("", replay("--impacts", "--from", "900").out());
    }

    @Test
    void theVerification() throws IOException {
        JsonNode json = replay("--verify").json();
        assertTrue(json.get("verified").booleanValue());
        assertTrue(json.get("difference").isNull());
        Files.writeString(file, new String(duel.bytes(), StandardCharsets.UTF_8).replaceFirst("\"thrust\":120",
            "\"thrust\":121"));
        Cli edited = replay("--verify");
        assertEquals(ExitStatus.FAILED, edited.status());
        assertFalse(edited.json().get("verified").booleanValue());
        assertEquals(1, edited.json().get("difference").get("turn").intValue());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--frames --player 0", "--quiet", "--from 3", "--open"})
    void whatIsNoObjectIsRefused(String options) {
        assertEquals(ExitStatus.UNUSABLE, replay(options.split(" ")).status());
    }
}
