package steward.guest;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import tools.jackson.databind.JsonNode;

/**
 * Matches with a referee that is a program of its own: one that speaks rightly, and wrongly in every way. It takes long
 * because each match starts a referee in Python, and some wait for answers that come late.
 */
@Tag("process")
@Timeout(120)
class GuestMatchTest {

    @TempDir
    private Path folder;
    private Path file;

    @BeforeEach
    void programs() throws IOException {
        file = folder.resolve("x.jsonl");
        assumeTrue(ProgramFinder.find("python3") != null && ProgramFinder.find("sh") != null,
            "skipped: there is no python3 or no sh");
        Files.copy(Path.of("src/test/resources/referees/standin.py"), folder.resolve("standin.py"));
    }

    /** A scene for so many players with the stand-in in a mode. */
    private String scene(String mode, int players, String more) throws IOException {
        return Files.writeString(folder.resolve(mode + ".json"), """
            { "name": "%s", "game": "guest", "players": %d,
              "referee": { "command": ["python3", "%s", "%s"]%s } }
            """.formatted(mode, players, folder.resolve("standin.py"), mode, more)).toString();
    }

    /** A bot that reads so many lines before each answer, and runs a command from a turn on; turns count from 0. */
    private String bot(String name, int lines, String answer, int turn, String then) throws IOException {
        return name + "=sh " + Files.writeString(folder.resolve(name + ".sh"), """
            turn=0
            while :; do
              %s
              if [ $turn -ge %d ]; then %s; fi
              echo %s
              turn=$((turn + 1))
            done
            """.formatted("IFS= read -r line || exit 0; echo \"$line\" >>%s; ".formatted(folder.resolve(name + ".txt"))
                .repeat(lines), turn, then, answer));
    }

    private Cli match(String scene, String... more) throws IOException {
        return Cli.run(List.of("match", "--scene", scene, "--bot", bot("low", 2, "1", 99, ":"), "--bot",
            bot("high", 2, "2", 99, ":"), "--seed", "7", "--time-factor", "20"), more);
    }

    private Cli verify() {
        return Cli.run("replay", file.toString(), "--verify", "--run-referee");
    }

    private void assertVerified(int turns) {
        assertEquals("verified: states of " + turns + " of " + turns + " turns and the result\n", verify().out());
    }

    @Test
    void pointsAreThoseOfTheScoresAndTheReplayVerifies() throws IOException {
        Cli cli = match(scene("good", 2, ""), "--out", file.toString()).done();
        assertTrue(cli.out().startsWith("high wins: the referee has ended the game, 20 turns (good, seed 7)"),
            cli.out());
        assertVerified(20);
        assertEquals("seed=7\n0\nseed=7\n1\n", Files.readString(folder.resolve("low.txt")).substring(0, 18));
        assertTrue(Files.readString(file).contains("""
            {"type":"turn","turn":3,"commands":[{"lines":["1"]},null]"""), Files.readString(file));
        String turn = Cli.run("replay", file.toString(), "--turn", "3").out();
        assertTrue(turn.contains("block NEXT_PLAYER_INPUT  lines seed=7, 1"), turn);
        String table = Cli.run("replay", file.toString()).out();
        assertFalse(table.contains("impact"), table);
    }

    /** The referee's words are the failure's text in a match, a series, a test, a replay and a check. */
    @Test
    void aBotThatTheRefereeThrowsOutHasFailed() throws IOException {
        String scene = scene("thrown", 2, "");
        Cli cli = match(scene, "--out", file.toString());
        assertTrue(cli.out().contains("high") && cli.out().contains("no such cell"), cli.out());
        assertTrue(verify().out().startsWith("verified"), cli.out());
        Files.writeString(file, Files.readString(file).replace("no such cell\"}", "other words\"}"));
        assertEquals(ExitStatus.FAILED, verify().status());
        String series = match(scene, "--games", "2").out();
        assertTrue(series.contains("no such cell") && series.matches("(?s).*\nhigh +0 +0 +2 +2 .*"), series);
        String check = Cli.run("check", "--scene", scene, "--time-factor", "20", "codingame:" + bot("high", 2, "2", 99,
            ":").substring("high=".length())).out();
        assertTrue(!check.contains("It is ready") && check.contains("no such cell"), check);
        String sprt = Cli.run("sprt", "--scene", scene, "--bot", bot("a", 2, "1", 99, ":"), "--bot",
            bot("b", 2, "2", 99, ":"), "--games", "4", "--time-factor", "20").out();
        assertTrue(sprt.contains("no such cell"), sprt);
    }

    /** Limits of 100 and 150 ms, as the SDK has two, are ten times as long; without limits no time counts. */
    @Test
    void theThirdLateAnswerIsAFailureWhereTimesCount() throws IOException {
        String scene = scene("struck", 2, "");
        List<String> call = List.of("match", "--scene", scene, "--bot", bot("quick", 2, "1", 99, ":"), "--json",
            "--bot");
        JsonNode struck = Cli.run(call, bot("slow", 2, "1", 1, "sleep 1.25"), "--time-factor", "10").json();
        assertTrue(struck.at("/players/1/fault").asString("").startsWith("late 3 times, after 1"), struck.toString());
        assertTrue(struck.at("/players/0/fault").isNull(), struck.toString());
        JsonNode free = Cli.run(call, bot("slow", 2, "1", 1, "sleep 0.2"), "--no-deadline").json();
        assertTrue(free.at("/players/1/fault").isNull(), free.toString());
    }

    @Test
    void aBotIsFedWhatItWasSent() throws IOException {
        match(scene("pairs", 2, ", \"properties\": {\"width\": \"12\"}"), "--out", file.toString());
        String bot = "sh " + folder.resolve("low.sh");
        String frames = Cli.run("replay", file.toString(), "--frames", "--player", "1", "--run-referee").out();
        assertTrue(frames.startsWith("setup of 1\nseed=7\nwidth=12\n0\nsetup of 1\nseed=7\nwidth=12\n1\n"), frames);
        Cli.run("feed", file.toString(), "--player", "0", "--run-referee", "--", bot).done();
        Files.delete(folder.resolve("standin.py"));
        assertEquals(frames, Cli.run("replay", file.toString(), "--frames", "--player", "1").done().out());
        String told = Cli.run("feed", file.toString(), "--player", "0", "--", bot).done().out();
        assertTrue(told.contains("10 the same, 0 different"), told);
        Files.writeString(file, Files.readString(file).replace("setup of 1", "setup of 2"));
        Cli changed = Cli.run("replay", file.toString(), "--frames", "--player", "1");
        assertEquals(ExitStatus.FAILED, changed.status());
        assertTrue(changed.err().contains("turn 1 differs when it is played again"), changed.err());
    }

    @Test
    void recordedBlocksThatNoRefereeSaysAreRefusedWithTheirLine() throws IOException {
        match(scene("good", 2, ""), "--out", file.toString());
        List<String> lines = Files.readAllLines(file);
        for (int line = 1; line <= 3; line += 2) {
            List<String> broken = new ArrayList<>(lines);
            broken.set(line - 1, lines.get(line - 1).replace("NEXT_PLAYER_INFO\",\"lines\":[\"",
                "NEXT_PLAYER_INFO\",\"lines\":[\"77"));
            Files.write(file, broken);
            Cli cli = Cli.run("replay", file.toString(), "--frames", "--player", "1");
            assertTrue(cli.err().startsWith("steward: " + file + ":" + line
                + (line == 1 ? ": start" : ": outcome") + ": the referee said NEXT_PLAYER_INFO [77"), cli.err());
        }
    }

    @Test
    void filesOfARefereeThatAreNotThereAreNamed() throws IOException {
        match(scene("good", 2, ""), "--out", file.toString());
        String replay = Files.readString(file);
        Files.writeString(folder.resolve("standin.py"), "# another one\n");
        Files.writeString(file, replay.replace("[\"python3\"", "[\"python3\",\"-Wd\",\"-X.y=1\",\"no/such.py\""));
        verify().assertRefused(
            "which is that of the referee's files here; no file is no/such.py");
        Files.writeString(file, replay);
        Files.delete(folder.resolve("standin.py"));
        verify().assertRefused(file + ":1: jar: found no file "
            + folder.resolve("standin.py") + ", expected the files of sha256:");
        Files.writeString(file, replay.replace("[\"python3\"", "[\"no-such-program\""));
        verify().assertRefused("referee.command: found \"no-such-program\", expected a program that is there");
        Files.writeString(file, replay.replaceFirst("\"command\":\\[.*?]", "\"classPath\":[\"no/such.jar\"]"));
        verify().assertRefused("referee.classPath: found \"no/such.jar\", expected folders and jars that are there");
    }

    /** A replay from somebody else may name any program of this machine. */
    @Test
    void theProgramThatAReplayNamesIsRunOnlyByAnOption() throws IOException {
        match(scene("good", 2, ""), "--out", file.toString());
        Files.delete(folder.resolve("standin.py"));
        for (String[] call : new String[][] {{"replay", file.toString(), "--verify"},
            {"feed", file.toString(), "--player", "0",
            "--replace", "--from-turn", "3", "--out", folder.resolve("y.jsonl").toString(), "--", "true"}}) {
            Cli cli = Cli.run(call);
            assertEquals(ExitStatus.UNUSABLE, cli.status(), cli.out());
            assertTrue(cli.err().contains("which is a program that the replay names and is not run"), cli.err());
            assertTrue(cli.err().contains("--run-referee runs it"), cli.err());
        }
        assertEquals(ExitStatus.DONE, Cli.run("replay", file.toString()).status());
    }

    @Test
    void theFirstDifferenceIsNamed() throws IOException {
        Path script = Files.writeString(folder.resolve("referee.sh"), "exec python3 " + folder.resolve("standin.py")
            + " good");
        String scene = scene("good", 2, "");
        Files.writeString(Path.of(scene), Files.readString(Path.of(scene)).replaceFirst("\\[.*]", "[\"sh\", \""
            + script + "\"]"));
        match(scene, "--out", file.toString());
        Files.writeString(folder.resolve("standin.py"), Files.readString(folder.resolve("standin.py"))
            .replace("f\"KEY_FRAME {turn}\"", "f\"KEY_FRAME {turn // 5 * 5}\""));
        Cli cli = verify();
        assertEquals(ExitStatus.FAILED, cli.status());
        assertTrue(cli.out().startsWith("differs: turn 2, "), cli.out());
        assertTrue(cli.out().contains("KEY_FRAME 1"), cli.out());
        Files.writeString(script, " ", StandardOpenOption.APPEND);
        verify().assertRefused(
            "which is that of the referee's files here");
    }

    @Test
    void blocksThatAreNotDeterminedAreLeftOut() throws IOException {
        match(scene("view", 2, ""), "--out", file.toString());
        assertEquals(ExitStatus.FAILED, verify().status());
        match(scene("view", 2, ", \"undetermined\": [\"METADATA\"]"), "--out", file.toString(), "--overwrite");
        assertVerified(20);
    }

    @Test
    void timesThatCountAreRecordedAndPlayedAgain() throws IOException {
        Cli cli = match(scene("monitored", 2, ""), "--out", file.toString()).done();
        assertTrue(Files.readString(file).contains("\"commands\":[{\"ms\":"), cli.out());
        assertVerified(20);
    }

    @Test
    void aBotThatFailsIsToldToTheRefereeAndTheGameGoesOn() throws IOException {
        Cli cli = Cli.run("match", "--scene", scene("good", 3, ""), "--bot", bot("low", 2, "1", 99, ":"), "--bot",
            bot("dies", 2, "9", 2, "exit 3"), "--bot", bot("high", 2, "2", 99, ":"), "--seed", "7", "--json",
            "--out", file.toString(), "--time-factor", "20").done();
        JsonNode result = cli.json();
        assertEquals(10, result.at("/players/1/score").asDouble());      // 9 + 9 - 8 rounds without an answer
        assertEquals(20, result.at("/players/2/score").asDouble());
        assertTrue(result.at("/players/1/fault").asString().contains("exited with status 3"), cli.out());
        assertVerified(23);
    }

    /** Readers of Java and Python end a line there: the bot could speak as the host. */
    @Test
    void aBotCannotSayMoreLinesThanItWasAskedFor() throws IOException {
        Cli cli = Cli.run("match", "--scene", scene("good", 2, ""), "--bot", bot("low", 2, "1", 99, ":"), "--bot",
            bot("sly", 2, "9", 1, "printf '9\\r[[GET_GAME_INFO] 0]\\n'"), "--time-factor", "20").done();
        assertTrue(cli.out().contains("found an end of line within a line, expected none"), cli.out());
    }

    @Test
    void aBotThatIsLateByTheLimitOfItsQuestionHasFailed() throws IOException {
        Cli cli = Cli.run("match", "--scene", scene("good", 2, ""), "--bot", bot("low", 2, "1", 99, ":"), "--bot",
            bot("late", 2, "9", 1, "sleep 1000"), "--time-factor", "0.2").done();
        assertTrue(cli.out().contains("600 ms"), cli.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "exit     | exited with status 3 before answering; its stderr: the map is missing",
        "fail     | failed: java.lang.NullPointerException | at Referee.gameTurn",
        "silence  | said nothing for 500 ms that ends its turn to speak",
        "flood    | said more than 16 MiB at a time",
        "errors   | exited with status 4 before answering; its stderr: e",
        "unknown  | said '[[GARBAGE] 1]', expected a block such as [[VIEW] 3]",
        "noise    | said 'debug: 7 bodies', expected a block",
        "lines    | said '[[VIEW] 9999999999]', expected a block",
        "number   | said NEXT_PLAYER_INFO [0, 1, 9999999999], expected a player 0..1",
        "nobody   | said NEXT_PLAYER_INFO [7, 1, 100], expected a player 0..1",
        "few      | said SCORES [0 1], expected a player and a score in each of 2 lines",
        "scores   | said SCORES before it asked anybody",
        "children | exited with status 5 before answering",
        })
    void whatTheRefereeDoesWrongIsItsFault(String line) throws IOException {
        assertFault(line);
    }

    @Tag("campaign")
    @ParameterizedTest
    @ValueSource(strings = {
        "huge     | said more than 16 MiB at a time",
        "endless  | asked more than 20000 times: the game does not end"})
    void whatTheRefereeDoesTooOftenIsItsFault(String line) throws IOException {
        assertFault(line);
    }

    private void assertFault(String line) throws IOException {
        String mode = line.split("\\|", 2)[0].strip();
        String problem = line.split("\\|", 2)[1].strip();
        String limit = mode.equals("silence") ? ", \"limitMs\": 500" : "";
        Cli cli = match(scene(mode, 2, limit));
        assertEquals(ExitStatus.FAILED, cli.status(), cli.out() + cli.err());
        assertTrue(cli.err().contains("the match could not be brought to a result: the referee " + problem),
            cli.err());
        assertFalse(cli.err().contains("low"), cli.err());
        assertNothingIsLeft();
    }

    private void assertNothingIsLeft() {
        List<ProcessHandle> left = ProcessHandle.allProcesses().filter(process -> process.info().commandLine()
            .orElse("").contains(folder.toString())).toList();
        assertDoesNotThrow(() -> CompletableFuture.allOf(left.stream().map(ProcessHandle::onExit)
            .toArray(CompletableFuture[]::new)).get(10, TimeUnit.SECONDS), left::toString);
    }

    @Test
    void aRefereeThatStaysAfterTheEndIsEnded() throws IOException {
        match(scene("stays", 2, "")).done();
        assertNothingIsLeft();
    }

    @Test
    void aSeriesGoesOnAfterFaultsOfTheRefereeAndCountsThem() throws IOException {
        Path games = folder.resolve("games");
        String scene = scene("good", 2, "");
        Files.writeString(folder.resolve("standin.py"), Files.readString(folder.resolve("standin.py"))
            .replace("turn = 0\n", "turn = 0\nif seed == 'seed=8': sys.exit('no such map')\n"));
        Cli cli = match(scene, "--games", "4", "--out", games.toString());
        assertEquals(ExitStatus.FAILED, cli.status(), cli.out() + cli.err());
        assertTrue(cli.out().contains("high"), cli.out());
        assertTrue((cli.out() + cli.err()).contains("no such map"), cli.out() + cli.err());
        try (var files = Files.list(games)) {
            assertEquals(3, files.count());
        }
        assertNothingIsLeft();
    }

    @ParameterizedTest
    @ValueSource(strings = {"explain", "simulate --scene", "tradeoff --scene", "match --accuracy exact --scene"})
    void whatNeedsTheRulesRefusesGuestsByName(String call) throws IOException {
        Cli.run((call + " " + scene("good", 2, "")).split(" "))
            .assertRefused("a referee of its own, expected a game that Steward computes");
    }

    @Test
    void aBotThatSpeaksJsonAndAProgramThatIsNotThereAreRefused() throws IOException {
        Cli.run("match", "--scene", scene("good", 2, ""), "--bot", "json:./a", "--bot", "./b")
            .assertRefused("has a referee of its own, expected a bot that speaks its lines, codingame");
        Path scene = Files.writeString(folder.resolve("none.json"), """
            {"name": "none", "game": "guest", "players": 2, "referee": {"command": ["no-such-program"]}}""");
        Cli.run("match", "--scene", scene.toString(), "--bot", "a", "--bot", "b")
            .assertRefused("referee.command: found \"no-such-program\", expected a program that is there");
    }

    @Test
    void theExampleOfTheManualPlays() throws IOException {
        Path scene = Files.writeString(folder.resolve("heap.json"), """
            {"name": "heap", "game": "guest", "players": 2,
             "referee": {"command": ["python3", "src/examples/referees/heap.py"]}}""");
        Cli cli = Cli.run("match", "--scene", scene.toString(), "--bot", bot("one", 1, "1", 99, ":"), "--bot",
            bot("never", 1, "0", 99, ":"), "--time-factor", "50", "--out", file.toString()).done();
        assertTrue(cli.out().startsWith("one wins: the referee has ended the game, 2 turns (heap, "), cli.out());
        assertTrue(verify().out().startsWith("verified"), cli.out());
        assertTrue(Cli.run("replay", file.toString()).out().contains(" stones are left"), cli.out());
    }
}
