package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.scene.json.SceneException;

/** Files that are no replays, or damaged ones: refused with the place, what was found and what was expected. */
class RefusedReplayTest {

    private static String refusal(String replay) {
        return assertThrows(ReplayException.class, () -> Recorded.verify(replay)).getMessage();
    }

    private static String refusal(int lineNumber, String from, String to) {
        List<String> lines = new ArrayList<>(Recorded.of("duel", 1).lines());
        String line = lines.get(lineNumber);
        assertTrue(line.contains(from), line);
        lines.set(lineNumber, line.replace(from, to));
        return refusal(String.join("\n", lines) + "\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"hello", "\n", "{}\n", "{\"type\":\"turn\"}\n", "\0\0\0", "{\"type\":\"steward-replay\"}\n",
        " {\"type\":\"steward-replay\",\"format\":1}"})
    void garbage(String text) {
        assertEquals("r.jsonl:1: found no replay header, expected a line that begins with "
            + "{\"type\":\"steward-replay\",\"format\":", refusal(text));
    }

    @Test
    void aNewerFormat() {
        assertEquals("r.jsonl:1: format: found 4, expected 3: a newer version of Steward wrote this replay",
            refusal("{\"type\":\"steward-replay\",\"format\":4,\"whatever\":[]}\n"));
        assertEquals("r.jsonl:1: format: found 0, expected 3; formats 1 and 2 are no longer read",
            refusal("{\"type\":\"steward-replay\",\"format\":0}\n"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "\"format\":3 | \"format\":\"x\" | format: found \"x\", expected a whole number",
        "\"seed\":\"1\" | \"seed\":\"one\" | seed: found \"one\", expected a whole number of 64 bits",
        "\"seed\":\"1\" | \"seed\":1 | seed: found 1, expected a string",
        "\"seed\":\"1\", | `` | seed: found nothing, expected a string",
        "\"timeFactor\":null | \"timeFactor\":\"x\" | timeFactor: found \"x\", expected a number or null",
        "{\"name\":\"P1\", | {\"n\":\"P1\", | "
            + "players[1]: found no name, expected an object with name and bot",
        "\"bot\":\"P0\", | `` | players[0]: found no bot, expected an object with name and bot",
        "\"players\":[{\"name\" | \"players\":[1,{\"name\" | players[0]: found a number, expected an object",
        "\"protocol\":\"json\"}] | \"protocol\":\"JSON\"}] | "
            + "players[1].protocol: found \"JSON\", expected \"json\" or \"codingame\"",
        "\"protocol\":\"json\"}] | \"protocol\":\"json\",\"time\":{\"firstAnswerMs\":9,\"answerMs\":0}}] | "
            + "players[1]: time: answerMs: found 0, expected 1 to 3600000",
        "\"protocol\":\"json\"}] | \"protocol\":\"json\",\"time\":{\"answerMs\":9}}] | "
            + "players[1]: time: firstAnswerMs: found nothing, expected a whole number",
        ",{\"name\":\"P1\",\"bot\":\"P1\",\"protocol\":\"json\"} | `` | players: found 1, expected 2 as in the scene",
        "\"game\":\"pod-race\",\"s | \"game\":\"chess\",\"s | game: found \"chess\", "
            + "expected \"pod-race\" as in the scene"})
    void wrongHeaders(String from, String to, String message) {
        assertEquals("r.jsonl:1: " + message, refusal(0, from, to));
    }

    @Test
    void aHeaderWithoutPlayers() {
        String header = Recorded.of("duel", 1).lines().get(0)
            .replaceFirst("\"players\":\\[.*?]", "\"players\":[]");
        assertEquals("r.jsonl:1: players: found none, expected those of the scene", refusal(header + "\n"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "[] | found an array", "`` | found an empty line", "17 | found a number", "null | found null"})
    void aLineThatIsNoObject(String line, String found) {
        String header = Recorded.of("duel", 1).lines().get(0);
        assertEquals("r.jsonl:2: " + found + ", expected one object a line", refusal(header + "\n" + line + "\n"));
    }

    @Test
    void aSceneThatNobodyCanPlay() {
        List<String> lines = new ArrayList<>(Recorded.of("duel", 1).lines());
        lines.set(0, lines.get(0).replace("\"game\":\"pod-race\"", "\"game\":\"chess\""));
        String replay = String.join("\n", lines) + "\n";

        SceneException refusal = assertThrows(SceneException.class, () -> Recorded.verify(replay));

        assertTrue(refusal.getMessage().startsWith("r.jsonl (scene):1:"), refusal.getMessage());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "\"type\":\"turn\" | \"type\":\"tune\" | type: found \"tune\", expected \"turn\" or \"result\"",
        "\"type\":\"turn\", | `` | type: found nothing, expected a string",
        "\"turn\":5 | \"turn\":5.5 | turn: found 5.5, expected a whole number",
        "\"turn\":5 | \"turn\":99999999999 | turn: found 99999999999, expected a whole number below 2^31",
        "\"commands\":[ | \"commands\":0,\"faults\":[ | commands: found 0, expected an array",
        "\"commands\":[ | \"commands\":0,\"comands\":[ | comands: unknown field, expected one of type, turn, commands, "
            + "faults, outcome, messages, stderr, server, turnHash, times; did you mean commands?",
        "\"outcome\":{ | \"stderr\":[null,null],\"outcome\":{ | outcome: found behind stderr, expected before it",
        "\"turnHash\":\" | \"stderr\":\" | turnHash: found nothing, expected a string",
        "\"outcome\":{ | \"messages\":{ | outcome: found nothing, expected an object",
        "\"outcome\" | \"faults\":[1,null],\"outcome\" | faults[0]: found a number, expected a string or null",
        "\"outcome\" | \"faults\":[null],\"outcome\" | faults: found 1 entries, expected 2",
        "\"turn\":5 | \"turn\":5,\"turn\":5 | turn: found twice, expected once"})
    void damagedTurns(String from, String to, String message) {
        assertEquals("r.jsonl:6: " + message, refusal(5, from, to));
    }

    @Test
    void aLineThatIsNotJsonIsNamedWithItsColumn() {
        String message = refusal(5, "\"turn\":5", "\"turn\":5x");

        assertTrue(message.startsWith("r.jsonl:6:24: not JSON: "), message);
    }

    /** The JSON reader's own limits on numbers and names say no column. */
    @Test
    void aLineThatTheJsonReaderRefuses() {
        String number = refusal(5, "\"turn\":5", "\"turn\":5" + "0".repeat(2000));
        String name = refusal(5, "\"turn\":5", "\"turn\":5,\"" + "n".repeat(60_000) + "\":1");
        String nested = refusal(5, "\"turn\":5", "\"turn\":5,\"n\":" + "[".repeat(1000) + "]".repeat(1000));

        for (String message : List.of(number, name, nested)) {
            assertTrue(message.startsWith("r.jsonl:6"), message);
        }
    }

    @Test
    void anotherNumberThatNobodyCanHold() {
        List<String> lines = new ArrayList<>(Recorded.of("duel", 1).lines());
        lines.set(5, lines.get(5).replaceFirst("\"vx\":-?[0-9]+", "\"vx\":1e99999999999"));

        assertEquals("outcome.state.bodies[0].vx".replace("outcome.", ""),
            Recorded.verify(String.join("\n", lines) + "\n").difference().field());
    }

    @Test
    void foldersAndMissingFiles(@TempDir Path folder) {
        assertEquals(folder + ": found a folder, expected a replay file",
            assertThrows(ReplayException.class, () -> ReplayReader.open(folder)).getMessage());
        assertThrows(NoSuchFileException.class, () -> ReplayReader.open(folder.resolve("none.jsonl")));
    }

    @Test
    void aFileIsOpenedByItsPath(@TempDir Path folder) throws IOException {
        Path file = Files.write(folder.resolve("m.jsonl"), Recorded.of("duel", 1).bytes());
        try (ReplayReader reader = ReplayReader.open(file)) {
            assertEquals(file.toString(), reader.source());
            assertEquals(1, reader.header().seed());
        }
        Files.write(file, "nothing of the kind".getBytes(StandardCharsets.UTF_8));
        String refusal = assertThrows(ReplayException.class, () -> ReplayReader.open(file)).getMessage();
        assertTrue(refusal.startsWith(file + ":1: "), refusal);
    }
}
