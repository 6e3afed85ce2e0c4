package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;

/** Games of referees of their own, played by a small host that is not Steward's, imported and played again. */
@Tag("process")
@Timeout(120)
@Execution(ExecutionMode.CONCURRENT)
class GuestImportTest {

    private static final Path REFEREES = Path.of("src/test/resources/referees").toAbsolutePath();

    @TempDir
    private Path folder;
    private Path replay;

    @BeforeEach
    void programs() {
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        replay = folder.resolve("game.jsonl");
    }

    /** The result of a game as the SDK's runner writes it. */
    private static String played(String mode, String... players) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of("python3", REFEREES.resolve("runner.py").toString(), "7"));
        words.addAll(List.of(players));
        words.addAll(List.of("--", "python3", REFEREES.resolve("standin.py").toString(), mode));
        Process process = new ProcessBuilder(words).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor());
        return text;
    }

    private Cli imported(String mode, String json, String... more) throws IOException {
        Path scene = Files.writeString(folder.resolve("scene.json"), """
            {"name": "standin", "game": "guest", "players": 2, "referee": {"command": ["python3", "%s", "%s"]}}"""
            .formatted(REFEREES.resolve("standin.py"), mode));
        List<String> words = new ArrayList<>(List.of("import", Files.writeString(folder.resolve("game.json"), json)
            .toString(), "--scene", scene.toString(), "--out", replay.toString(), "--overwrite"));
        words.addAll(List.of(more));
        return Cli.run(words.toArray(String[]::new));
    }

    @Test
    void aGameIsComparedWholeAndAgainByTheReplay() throws IOException, InterruptedException {
        Cli cli = imported("good", played("good", "1", "2,2,-"));
        assertEquals(ExitStatus.DONE, cli.status(), cli.out() + cli.err());
        assertTrue(cli.out().startsWith("imported: ") && cli.out().contains("\nverified: states of "), cli.out());
        Cli again = Cli.run("replay", replay.toString(), "--verify", "--run-referee");
        assertTrue(again.out().startsWith("verified: ") && again.out().contains("\nnot compared: "), again.out());
        assertTrue(Cli.run("replay", replay.toString()).out().contains("P1 failed: no answer in the recording"));
    }

    /** Every text of the file is changed once, and the change is found. */
    @Test
    void aViewASummaryAScoreAndAnAnswerThatDifferAreFound() throws IOException, InterruptedException {
        String json = played("good", "1", "2");
        for (String[] change : new String[][] {{"KEY_FRAME 4\\n{}", "KEY_FRAME 4\\n{ }", "view line 1, character 1"},
            {"KEY_FRAME 4", "KEY_FRAME 5", "view line 0, character 10"},
            {"\"scores\": {\"0\": 10", "\"scores\": {\"0\": 11", "scores line 0"},
            {"\"summaries\": [\"\"", "\"summaries\": [\"x\"", "start, summary line 0"}}) {
            assertTrue(json.contains(change[0]), json);
            Cli cli = imported("good", json.replaceFirst(Pattern.quote(change[0]),
                Matcher.quoteReplacement(change[1])));
            assertEquals(ExitStatus.FAILED, cli.status(), cli.out() + cli.err());
            assertTrue(cli.out().contains("\ndiffers: ") && cli.out().contains(change[2]), cli.out());
        }
    }

    /** The third late answer puts a player out; the file has no times but those that the views show. */
    @Test
    void timesOfAnswersAreThoseThatTheViewsShow() throws IOException, InterruptedException {
        Cli cli = imported("shown", played("shown", "1@5,1@0,1@31", "2@120,2@7,2@130,2@0,2@149,2@1"));
        assertEquals(ExitStatus.DONE, cli.status(), cli.out() + cli.err());
        assertTrue(cli.out().contains("those that views show"), cli.out());
        String text = Files.readString(replay);
        for (int ms : new int[] {5, 31, 120, 7, 130}) {
            assertTrue(text.contains("{\"ms\":" + ms + ","), text);
        }
    }

    @Test
    void aRecordedGameIsPlayedAgainUntilTheOtherIsSentOtherLines() throws IOException, InterruptedException {
        imported("good", played("good", "1", "2"));
        Path bot = Files.writeString(folder.resolve("bot.sh"), "while read -r a && read -r b; do echo $1; done");
        Cli cli = Cli.run("match", "--recorded", replay.toString(), "--as", "P1", "--bot", "new=sh " + bot + " 2",
            "--run-referee", "--time-factor", "20");
        assertTrue(cli.out().contains("game.jsonl  unchanged to the end: won"), cli.out() + cli.err());
        Cli refused = Cli.run("match", "--recorded", replay.toString(), "--as", "P1", "--bot", "sh " + bot + " 2");
        assertTrue(refused.status() == ExitStatus.UNUSABLE && refused.err().contains("--run-referee"), refused.err());
    }

    @Test
    void filesThatCannotBeUsedAreRefusedWithTheirPlace() throws IOException, InterruptedException {
        String json = played("good", "1", "2");
        for (String[] change : new String[][] {{"\"seed=7\"", "\"\"", "refereeInput: found no seed, expected seed=N"},
            {"\"index\": 1", "\"index\": 1}, {\"index\": 2", "found 3 players, expected 2, as many as the scene"},
            {"\"uinput\"", "\"failCause\": \"no map\", \"uinput\"", "failCause: found \"no map\""},
            {"KEY_FRAME 0", "0", "expected CodinGame's game result with an array"}}) {
            Cli cli = imported("good", json.replace(change[0], change[1]));
            assertEquals(ExitStatus.UNUSABLE, cli.status(), cli.out());
            assertTrue(cli.err().contains(change[2]), cli.err());
        }
        Cli cut = imported("good", json.substring(0, json.length() / 2));
        assertTrue(cut.err().contains("it was cut off"), cut.err());
        assertTrue(Cli.run("import", folder.resolve("game.json").toString(), "--scene", "duel", "--out",
            folder.resolve("x").toString()).status() == ExitStatus.UNUSABLE);
    }
}
