package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.InProcessPlayer;
import steward.bot.process.BotProcess;
import steward.bots.BundledBotMatches;
import steward.bots.Racer;
import steward.cli.Main;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.TestScenes;
import steward.match.TimeControl;

/** What the README shows is true: its frames are frames, its scene is a scene, its bot plays. */
class ReadmeTest {

    private static String block(String language, int number) throws IOException {
        Matcher fences = Pattern.compile("```" + language + "\\R(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("README.md")));
        for (int k = 0; k <= number; k++) {
            assertEquals(true, fences.find(), language + " block " + k);
        }
        return fences.group(1);
    }

    @Test
    void itsFramesAreValid() throws IOException {
        String[] lines = block("json", 0).strip().split("\\R");
        List<String> names = List.of("setup", "turn", "end");
        assertEquals(names.size(), lines.length);
        for (int k = 0; k < lines.length; k++) {
            assertEquals(List.of(), Schemas.problems(Schemas.open(names.get(k)), lines[k]), names.get(k));
        }
        assertEquals(List.of(), Schemas.problems(Schemas.open("answer"), block("json", 1).strip()));
    }

    @Test
    void itsSceneCanBePlayed() throws IOException {
        assertEquals("walled-race", TestScenes.TYPES.open(block("json", 2), "README.md").scene().name());
    }

    @Test
    @Tag("process")
    void itsBotWinsTheMatchThatIsShown(@TempDir Path folder) throws Exception {
        String python = "python3";
        assumeTrue(runs(python), "skipped: there is no python3 on the PATH");
        Path bot = Files.writeString(folder.resolve("bot.py"), block("python", 0));
        MatchResult result = new Referee(TestScenes.open("mad-pod-racing"), 7,
            List.of(new BotProcess("me", List.of(python, bot.toString())),
                new InProcessPlayer("racer", BundledBotMatches.asBot(new Racer()))),
            TimeControl.UNLIMITED, new MatchListener() { }).play();

        assertNull(result.players().get(0).fault());
        assertEquals(0, result.winner());
        String shown = block("json", 0).strip().split("\\R")[2];
        assertEquals(true, shown.contains("\"turns\":" + result.turns() + ","), "the README says " + shown);
    }

    /** Every command line it shows starts with a command that exists. */
    @Test
    void itsCommandsExist() throws IOException {
        List<String> unknown = new ArrayList<>();
        Matcher calls = Pattern.compile("(?m)^ {4}(?:source <\\()?steward ([a-z-]+)")
            .matcher(Files.readString(Path.of("README.md")));
        int seen = 0;
        while (calls.find()) {
            seen++;
            String command = calls.group(1);
            if (!command.startsWith("--")) {
                if (!Main.commands().contains(command)) {
                    unknown.add(command);
                }
            }
        }
        assertEquals(List.of(), unknown);
        assertEquals(true, seen >= 8, "command lines seen: " + seen);
    }

    private static boolean runs(String program) {
        try {
            return new ProcessBuilder(program, "--version").start().waitFor() == 0;
        } catch (IOException | InterruptedException problem) {
            return false;
        }
    }
}
