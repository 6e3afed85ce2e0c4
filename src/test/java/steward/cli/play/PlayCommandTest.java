package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import steward.cli.ProcessTest;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code steward play} as rating tools call it. */
class PlayCommandTest {

    @TempDir
    private Path folder;
    private TextShellBots bots;

    @BeforeEach
    void makeBots() {
        bots = new TextShellBots(folder);
    }

    private static JsonNode play(String one, String two, String... more) {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        List<String> arguments = new ArrayList<>(List.of("play", "--json-league", one, two, "--scene", "duel",
            "--no-deadline"));
        arguments.addAll(List.of(more));
        Cli cli = Cli.run(arguments.toArray(String[]::new));
        assertTrue(cli.err().lines().allMatch(line -> line.matches("steward: warning: .* has failed in .*|  .*")),
            cli.err());
        assertEquals(0, cli.status());
        return cli.json();
    }

    @Test
    @Tag("process")
    void printsOneObject() {
        JsonNode json = play(bots.idler(0), bots.driver(), "--seed", "7");

        assertEquals(List.of("ranks", "errors", "faults", "test_data", "player_data", "attributes",
            "played_again"), new ArrayList<>(json.propertyNames()));
        assertEquals("[1,0]", json.get("ranks").toString());
        assertEquals("[0,0]", json.get("errors").toString());
        assertEquals("{\"seed\":7}", json.get("test_data").toString());
        JsonNode data = json.get("player_data").get(1);
        assertEquals("\"0.5\"", data.get("half").toString());
        assertTrue(data.get("turns").isInt());
        JsonNode last = json.get("attributes").get(json.get("attributes").size() - 1);
        assertEquals(List.of("name", "player", "turn", "value"), new ArrayList<>(last.propertyNames()));
        assertEquals("x", last.get("name").asString());
        assertTrue(last.get("player").isNull());
        assertEquals(1, last.get("turn").intValue());
        assertTrue(last.get("value").isString());
    }

    @Test
    @Tag("process")
    void theReplayIsWrittenAndAnotherFileIsKept() throws IOException {
        Path replay = folder.resolve("match.json");
        play(bots.idler(0), bots.driver(), "--seed", "7", "--out", replay.toString());
        play(bots.idler(0), bots.driver(), "--seed", "7", "--out", replay.toString());
        assertEquals(0, Cli.run("replay", replay.toString(), "--verify").status());

        Files.writeString(replay, "my notes");
        Cli refused = Cli.run("play", "--json-league", "true", "true", "--out", replay.toString());
        assertEquals(2, refused.status());
        assertTrue(refused.err().contains("found a file of another kind, which is kept"), refused::err);
        assertEquals("my notes", Files.readString(replay));
    }

    @Test
    @Tag("process")
    void aBotThatFailsIsAResult() {
        JsonNode json = play(bots.driver(), bots.idler(2));
        assertEquals("[0,1]", json.get("ranks").toString());
        assertEquals("[0,1]", json.get("errors").toString());
        JsonNode tied = play(bots.idler(1), "true");
        assertEquals("[0,0]", tied.get("ranks").toString());
        assertEquals("[1,1]", tied.get("errors").toString());
        assertTrue(tied.get("test_data").get("seed").isIntegralNumber());
    }

    /** The other bots of a league play on, however one of them fails. */
    @ParameterizedTest
    @Tag("process")
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "FOLDER/no/bot | bot 'codingame:FOLDER/no/bot': there is no file 'FOLDER/no/bot'",
        "FOLDER | bot 'codingame:FOLDER': 'FOLDER' is a directory; expected an executable program",
        "builtin:nobody | bot 'builtin:nobody': there is no builtin bot 'nobody'",
        "json: | bot 'json:': there is no command after 'json:'",
        "'cat | bot ''cat', column 1: the single quote is never closed"})
    void aBotThatCannotBeStartedHasFailed(String command, String expected) {
        String bot = command.replace("FOLDER", folder.toString());
        String reason = expected.replace("FOLDER", folder.toString());
        JsonNode json = play(bots.idler(0), bot);
        assertEquals("[0,1]", json.get("ranks").toString());
        assertEquals("[0,1]", json.get("errors").toString());
        assertTrue(json.get("faults").get(0).isNull());
        String fault = json.get("faults").get(1).asString();
        assertTrue(fault.startsWith("could not be started: " + reason), fault);
        assertEquals("[1,0]", play(bot, bots.idler(0)).get("errors").toString());
        assertEquals("[1,1]", play(bot, bot).get("errors").toString());
    }

    /** Without setsid the program is started by Java itself, which makes an exception of what is the bot's failure. */
    @Test
    @Tag("process")
    void aBotThatTheSystemRefusesHasFailedWithSetsidAndWithout() throws IOException, InterruptedException {
        Path broken = Files.writeString(folder.resolve("broken"), "#!/no/such/interpreter\n");
        assumeTrue(broken.toFile().setExecutable(true) && Files.isExecutable(Path.of("/bin/sh")));
        Path programs = Files.createDirectory(folder.resolve("programs"));
        assumeTrue(Files.copy(Path.of("/bin/sh"), programs.resolve("sh")).toFile().setExecutable(true));
        assertTheOtherWins(play(broken.toString(), bots.idler(0), "--seed", "1"));
        String said = ProcessTest.shell("PATH='" + programs + "' " + ProcessTest.steward("play", "--json-league",
            "--scene", "duel", "--seed", "1", broken.toString(), bots.idler(0)));
        assertTrue(said.endsWith("\nstatus 0\n"), said);
        String line = said.lines().filter(each -> each.startsWith("{")).findFirst().orElse(said);
        assertTheOtherWins(JsonMapper.shared().readTree(line));     // beside it may stand that there is no sandbox
    }

    private static void assertTheOtherWins(JsonNode json) {
        assertEquals("[1,0]", json.get("errors").toString());
        String fault = json.get("faults").get(0).asString();
        assertTrue(fault.startsWith("exited with status 127 before answering (127: a command was not found)"), fault);
    }

    @Test
    @Tag("process")
    void aDrawIsNoError() {
        JsonNode json = play(bots.idler(0), bots.idler(0));
        assertEquals("[0,0]", json.get("ranks").toString());
        assertEquals("[0,0]", json.get("errors").toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "cat cat | --json-league",
        "--json-league cat | found 1 bot, expected 2 bots",
        "--json-league cat cat cat | found 3 bots, expected 2 bots",
        "--json-league cat cat --seed x | found 'x', expected a whole number of 64 bits",
        "--json-league cat cat --scene nowhere | nowhere: found no such file",
        "--json-league cat cat --time-factor nan | expected a number"})
    void aWrongCallIsToldOnStderrAlone(String arguments, String problem) {
        Cli cli = Cli.run(("play " + arguments).split(" "));
        assertEquals(2, cli.status());
        assertEquals("", cli.out());
        assertTrue(cli.err().contains(problem), cli.err());
    }
}
