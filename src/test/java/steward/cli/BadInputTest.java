package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.scene.SceneFiles;

/** Calls and inputs that cannot be used: each with its message on stderr, status 2, and nothing played or written. */
class BadInputTest {

    @TempDir
    private Path folder;

    private static void refused(String message, String... arguments) {
        Cli.run(arguments).assertRefused(message);
    }

    static Stream<Arguments> calls() {
        return Stream.of(
            Arguments.of("found no such file", "match --scene nowhere --bot sh --bot sh"),
            Arguments.of("did you mean \"duel\"", "match --scene duell --bot sh --bot sh"),
            Arguments.of("found 1 bot, expected 2 bots", "match --bot sh"),
            Arguments.of("found 3 bots, expected 2 bots", "match --bot sh --bot sh --bot sh"),
            Arguments.of("there is no program 'no-such-program'", "match --bot sh --bot no-such-program"),
            Arguments.of("there is no file './no-such-file'", "match --bot sh --bot ./no-such-file"),
            Arguments.of("there is no builtin bot 'nobody'", "match --bot sh --bot builtin:nobody"),
            Arguments.of("there is no command", "match --bot sh --bot name="),
            Arguments.of("column 1: the single quote is never closed", "match --bot sh --bot \"'sh\""),
            Arguments.of("--json and --quiet exclude each other", "match --bot sh --bot sh --json --quiet"),
            Arguments.of("--games: found 0, expected 1", "match --bot sh --bot sh --games 0"),
            Arguments.of("--threads: found '0', expected 1 to 256, or auto",
                "match --bot sh --bot sh --games 2 --threads 0"),
            Arguments.of("--threads: found '257', expected 1 to 256, or auto",
                "match --bot sh --bot sh --games 2 --threads 257"),
            Arguments.of("--threads is for many games", "match --bot sh --bot sh --threads 2"),
            Arguments.of("--time-factor: found 0.0, expected", "match --bot sh --bot sh --time-factor 0"),
            Arguments.of("--time-factor: found NaN, expected", "match --bot sh --bot sh --time-factor NaN"),
            Arguments.of("exclude each other", "match --bot sh --bot sh --time-factor 2 --no-deadline"),
            Arguments.of("found 'x', expected a whole number of 64 bits", "match --bot sh --bot sh --seed x"),
            Arguments.of("9223372036854775808", "match --bot sh --bot sh --seed 9223372036854775808"),
            Arguments.of("--overwrite: expected --out", "match --bot sh --bot sh --overwrite"),
            Arguments.of("Unknown option: '--sead=1'", "match --bot sh --bot sh --sead=1"),
            Arguments.of("Missing required parameter: 'FILE'", "replay"),
            Arguments.of("found no such file, expected a replay", "replay nowhere.jsonl"),
            Arguments.of("found no such file, expected a replay", "replay nowhere.jsonl --verify"),
            Arguments.of("found a folder, expected a replay file", "replay /"),
            Arguments.of("--frames: expected --player P", "replay x --frames"),
            Arguments.of("--player is for --frames", "replay x --player 0"),
            Arguments.of("--turn and --from or --to exclude", "replay x --turn 1 --to 2"),
            Arguments.of("--turn: found 0, expected 1 or more", "replay x --turn 0"),
            Arguments.of("--to: found 1, expected at least --from, which is 2", "replay x --from 2 --to 1"),
            Arguments.of("--from: found -1, expected 0 or more", "replay x --from -1"),
            Arguments.of("--verify takes the whole match", "replay x --verify --turn 2"),
            Arguments.of("found no such file", "explain nowhere"),
            Arguments.of("found 'x', expected a whole number", "demo --seed x"));
    }

    @ParameterizedTest
    @MethodSource("calls")
    void aWrongCall(String message, String call) {
        refused(message, "--cli", call);
    }

    static Stream<Arguments> scenes() {
        return Stream.of(
            Arguments.of("{\"name\": ", "\"name\" \"x\",", ":2:"),
            Arguments.of("\"players\": 2", "\"players\": \"two\"", "players"),
            Arguments.of("\"players\": 2", "\"players\": 99", "players"),
            Arguments.of("\"drag\"", "\"drgg\"", "did you mean \"drag\""),
            Arguments.of("\"game\": \"pod-race\"", "\"game\": \"pot-race\"", "did you mean \"pod-race\""),
            Arguments.of("\"radius\": 400", "\"radius\": -400", "radius"));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void aWrongScene(String right, String wrong, String message) throws IOException {
        String duel = SceneFiles.load("duel").text();
        String text = duel.contains(right) ? duel.replace(right, wrong) : "{\n" + wrong + duel.substring(1);
        Path file = Files.writeString(folder.resolve("scene.json"), text);
        refused(file + ":", "match", "--scene", file.toString(), "--bot", "sh", "--bot", "sh");
        refused(message, "explain", file.toString());
    }

    @Test
    void anOutputThatCannotBeWrittenIsFoundBeforeTheMatch() throws IOException {
        Path played = folder.resolve("played");
        String bot = "sh -c 'touch " + played + "'";
        for (String out : List.of(folder + "/missing/x.jsonl", folder.toString(), "/proc/x.jsonl")) {
            refused(out, "match", "--scene", "duel", "--bot", bot, "--bot", bot, "--out", out);
        }
        assertFalse(Files.exists(played));
    }

    @Test
    void anOutputFolderWithoutPermissionIsFoundBeforeTheMatch() throws IOException {
        Path closed = Files.createDirectory(folder.resolve("closed"));
        assertTrue(closed.toFile().setWritable(false));
        assumeTrue(!Files.isWritable(closed), "this user may write everywhere");
        refused("no permission", "match", "--bot", "sh", "--bot", "sh", "--out", closed + "/x.jsonl");
        refused("no permission", "match", "--bot", "sh", "--bot", "sh", "--out", closed.toString(), "--games", "2");
    }

    @Test
    void aReplayThatExistsIsKept() throws IOException {
        Path file = Files.writeString(folder.resolve("x.jsonl"), "precious");
        refused("exists already, and is kept", "match", "--bot", "sh", "--bot", "sh", "--out", file.toString());
        Path second = Files.writeString(folder.resolve("game-0002.jsonl"), "precious");
        refused(second + ": exists already", "match", "--bot", "sh", "--bot", "sh", "--out", folder.toString(),
            "--games", "2");
        refused("found a file, expected a folder", "match", "--bot", "sh", "--bot", "sh", "--out", file.toString(),
            "--games", "2");
        assertEquals("precious", Files.readString(file));
        assertEquals("precious", Files.readString(second));
        assertFalse(Files.exists(folder.resolve("game-0001.jsonl")));
    }

    @Test
    void aRefusedCallLeavesNoFile() {
        Path file = folder.resolve("x.jsonl");
        refused("there is no program", "match", "--bot", "sh", "--bot", "no-such-program", "--out", file.toString());
        assertFalse(Files.exists(file));
    }

    @Test
    void aFileThatIsNoReplay() throws IOException {
        Path file = folder.resolve("x.jsonl");
        for (String mode : List.of("--verify", "--impacts", "--turn=1", "--quiet")) {
            Files.writeString(file, "");
            refused("found an empty file, expected a replay", "replay", file.toString(), mode);
            Files.writeString(file, "{\"type\":\"turn\"}\n");
            refused(file + ":1: found no replay header", "replay", file.toString(), mode);
            Files.writeString(file, "{\"type\":\"steward-replay\",\"format\":999}\n");
            refused("format: found 999, expected at most", "replay", file.toString(), mode);
        }
    }
}
