package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.league.LeagueFolder;
import steward.league.store.GameStore;

/** Versions of bots in leagues that are moved, and of bots that write to their own files. */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class BotVersionsTest {

    @TempDir
    private Path folder;
    private Path bots;

    @BeforeEach
    void makeLeague() throws IOException {
        ShellBots.shortDuel(folder);
        new TextShellBots(folder);
        done("init", "TMP/night", "--scene", "TMP/short.json", "--seed", "5");
        bots = Files.createDirectories(folder.resolve("night/bots"));
        String pod = Files.readString(folder.resolve("text pod.sh"));
        Files.writeString(bots.resolve("still.sh"), pod);
        Files.writeString(bots.resolve("self.sh"), "echo >>\"$0\" 2>/dev/null\n" + pod);
        done("add", "TMP/night", "still=codingame:sh still.sh stay 0", "--in", bots.toString());
        done("add", "TMP/night", "self=codingame:sh self.sh drive 0", "--in", bots.toString());
    }

    private String done(String... words) {
        Cli cli = Cli.league(folder, words).done();
        return cli.out() + cli.err();
    }

    private void setLevel(String level) throws IOException {
        Path settings = folder.resolve("night/league.json");
        Files.writeString(settings, Files.readString(settings).replaceFirst("\"level\": \"\\w+\"",
            "\"level\": \"" + level + "\""));
    }

    private List<String> versions(String league) {
        try (GameStore store = GameStore.read(new LeagueFolder(folder.resolve(league)))) {
            return store.versions().stream().map(version -> version.display() + " " + store.gamesOf(version.id()))
                .toList();
        }
    }

    /** At off each game of such a bot makes another version, and none of them counts. */
    @Test
    void aBotThatWritesToItselfIsPausedAtOff() throws IOException {
        setLevel("off");
        Cli run = Cli.league(folder, "run", "TMP/night", "--games", "8");
        assertEquals(1, run.status(), run.err());
        assertTrue(run.err().contains("self#3 is paused: " + bots.resolve("self.sh") + " has made a third version of "
            + "it within 20 games, and at --sandbox off a bot can write to its own files; 'steward league resume "),
            run.err());
        assertEquals(List.of("still 0", "self 0", "self#2 0", "self#3 0"), versions("night"));
    }

    @Test
    void whereBotsAreKeptApartItIsOneVersion() throws IOException {
        assumeTrue(SandboxSupport.problem(SandboxLevel.LIGHT) == null, "skipped: level light does not work here");
        setLevel("light");
        done("run", "TMP/night", "--games", "4");
        assertEquals(List.of("still 4", "self 4"), versions("night"));
    }

    @Test
    void aLeagueWithItsBotsCanBeMoved() throws IOException {
        String settings = Files.readString(folder.resolve("night/league.json"));
        assertTrue(settings.contains("\"folder\": \"bots\""), settings);
        assertFalse(settings.contains(folder.toString()), settings);
        Files.writeString(bots.resolve("self.sh"), Files.readString(bots.resolve("still.sh")) + "\n");
        done("run", "TMP/night", "--games", "2");
        Files.move(folder.resolve("night"), Files.createDirectories(folder.resolve("else/where")).resolve("day"));
        done("run", "TMP/else/where/day", "--games", "4");
        assertEquals(List.of("still 4", "self 4"), versions("else/where/day"));
        done("verify", "TMP/else/where/day");
    }

    @Test
    void aBotOutsideKeepsItsFolderAndIsMissedByName() throws IOException {
        Path outside = Files.createDirectories(folder.resolve("outside"));
        Files.copy(bots.resolve("still.sh"), outside.resolve("third.sh"));
        Cli.league(folder, "add", "TMP/night", "x=codingame:sh third.sh", "--in", bots.toString())
            .assertRefused("there is no file 'third.sh' in ");
        String said = done("add", "TMP/night", "third=codingame:sh third.sh drive 0", "--in", outside.toString());
        assertTrue(said.contains("Another version when one of these changes in " + outside + ": third.sh"), said);
        assertTrue(Files.readString(folder.resolve("night/league.json")).contains("\"folder\": \"" + outside + "\""));
        Files.move(outside, folder.resolve("gone"));
        Cli run = Cli.league(folder, "run", "TMP/night", "--games", "2");
        assertEquals(2, run.status(), run.err());
        assertTrue(run.err().contains("found no folder " + outside + ", in which it was added"), run.err());
    }

    /** The opponent rebuilds {@code new.sh} in the first game: no game counts for two programs. */
    private List<String> rebuilt(String... call) throws IOException {
        String pod = Files.readString(folder.resolve("text pod.sh"));
        Path built = Files.writeString(folder.resolve("new.sh"), pod);
        Files.deleteIfExists(folder.resolve("made"));
        Files.writeString(folder.resolve("old.sh"), "[ -e made ] || { echo >>new.sh; : >made; }\n" + pod);
        List<String> words = new ArrayList<>(List.of(call));
        words.addAll(List.of("--scene", folder.resolve("short.json").toString(), "--sandbox", "off", "--seed", "1",
            "--threads", "1"));
        Cli cli = Cli.run(words.toArray(new String[0]));
        assertTrue(cli.err().contains(built + " has changed"), cli.err() + cli.out());
        return List.of("" + cli.status(), cli.out());
    }

    private String[] bots(String... before) {
        List<String> words = new ArrayList<>(List.of(before));
        words.addAll(List.of("--bot", "new=codingame:sh new.sh drive 0", "--in", folder.toString(), "--bot",
            "old=codingame:sh old.sh stay 0", "--in", folder.toString()));
        return words.toArray(new String[0]);
    }

    @Test
    void aRebuiltProgramEndsATestWithoutALeague() throws IOException {
        List<String> sprt = rebuilt(bots("sprt", "--games", "6", "--random"));
        assertEquals("1", sprt.get(0));
        assertTrue(sprt.get(1).contains("not decided"), sprt.get(1));
        assertEquals("1", rebuilt(bots("match", "--games", "3", "--swap")).get(0));
        assertEquals("1", rebuilt("tune", "--bot", "codingame:sh new.sh {a:drive|stay} 0", "--in", folder.toString(),
            "--against", "old=codingame:sh old.sh stay 0", "--in", folder.toString(), "--games", "16", "--seeds", "1")
            .get(0));
    }

    @Test
    void inALeagueANewVersionBegins() throws IOException {
        String night = folder.resolve("night").toString();
        setLevel("off");
        assertEquals("0", rebuilt(bots("match", "--games", "2", "--swap", "--into", night)).get(0));
        assertEquals(List.of("new 0", "old 4", "new#2 4"), versions("night"));
        assertEquals("0", rebuilt(bots("sprt", "--games", "6", "--random", "--into", night)).get(0));
    }
}
