package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.command.Program;
import steward.bot.hold.HoldPolicy;

/** Files that belong to a bot, and the files that it sees of others. */
class StrictViewTest {

    @TempDir
    private Path folder;

    private Path program(String path, String text) throws IOException {
        Path file = folder.resolve(path);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        assertTrue(file.toFile().setExecutable(true));
        return file;
    }

    /** Programs that there are, with what they hold behind =; the words of a bot; the folders that are its own. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        mine/bot                                      | TMP/mine/bot                               | mine
        pyenv/shims/python mine/bot.py                | TMP/pyenv/shims/python -u TMP/mine/bot.py  | pyenv mine
        ruby/bin/ruby mine/bot=#!TMP/ruby/bin/ruby~-w | TMP/mine/bot                               | ruby mine
        jdk/bin/java libs/a.jar classes/Bot.class     | TMP/jdk/bin/java -cp TMP/libs/a.jar:TMP/classes Bot | \
        jdk libs classes
        """)
    void aBotHasItsFolderAndThatOfItsInterpreter(String programs, String words, String own) throws IOException {
        for (String each : programs.split(" ")) {
            String[] parts = each.split("=");
            program(parts[0], parts.length == 1 ? "" : parts[1].replace("TMP", folder.toString()).replace('~', ' '));
        }
        assertEquals(Stream.of(own.split(" ")).map(folder::resolve).collect(Collectors.toSet()),
            OwnFiles.of(Program.here(List.of(words.replace("TMP", folder.toString()).split(" ")))));
    }

    @Test
    void linksAreFollowed() throws IOException {
        Path real = program("versions/3/bin/python", "");
        Path link = folder.resolve("venv/bin/python");
        Files.createDirectories(link.getParent());
        Files.createSymbolicLink(link, real);
        assertEquals(Set.of(folder.resolve("venv"), folder.resolve("versions/3")),
            OwnFiles.of(Program.here(List.of(link.toString()))));
    }

    @Test
    void aFolderThatHoldsHomesIsNeverABotsOwn() {
        Path home = OwnFiles.home();
        Set<Path> own = OwnFiles.of(Program.here(List.of("/bin/sh", home.toString(), "/")));
        assertFalse(own.contains(home) || own.contains(Path.of("/")) || own.contains(home.getParent()), own.toString());
    }

    private static StrictView view(Path mine, Path other, Path... visible) {
        Isolation usual = Isolation.at(SandboxLevel.STRICT);
        return StrictView.of(Program.here(List.of(mine.toString())), List.of(Program.here(List.of(other.toString()))),
            new Isolation(SandboxLevel.STRICT, false, usual.limits(), usual.environment(), List.of(visible), List.of(),
                HoldPolicy.NEVER));
    }

    /** Files that are made below the folder of the test, by path. */
    private Map<Path, StrictView.Treatment> made(StrictView view) {
        Map<Path, StrictView.Treatment> made = new LinkedHashMap<>();
        view.entries().forEach((path, entry) -> {
            if (path.startsWith(folder)) {
                made.put(path, entry.treatment());
            }
        });
        return made;
    }

    /**
     * A bot, another, a folder that is shown as well ({@code .} is that of the test), and what becomes of which place,
     * in order. In a folder that is not shown there is nothing to hide; a bot inside the folder of another is shown
     * in it, and not hidden with it.
     */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        bots/mine/bot | bots/other/bot |   | bots/mine SHOW
        bots/mine/bot | bots/other/bot | . | . SHOW, bots/other HIDE_FOLDER
        bots/mine/bot | bots/bot       | . | . SHOW, bots HIDE_FOLDER, bots/mine SHOW
        bots/mine     | bots/other     |   | bots SHOW, bots/other HIDE_FILE
        """)
    void itsOwnFolderIsShownAndOthersAreHiddenInWhatIsShown(String mine, String other, String visible, String expected)
            throws IOException {
        Path[] shown = visible == null ? new Path[0] : new Path[] {folder};
        assertEquals(expected, made(view(program(mine, ""), program(other, ""), shown)).entrySet().stream()
            .map(entry -> (entry.getKey().equals(folder) ? "." : folder.relativize(entry.getKey())) + " "
                + entry.getValue()).collect(Collectors.joining(", ")));
    }

    /** A bot is started in the present folder, which has to be there, also where that is another bot's own. */
    @Test
    void thePresentFolderIsEmptyWhereItIsAnothersOwn() {
        assertEquals(StrictView.Treatment.EMPTY_FOLDER, StrictView.of(Program.here(List.of("/usr/bin/env")),
            List.of(Program.here(List.of("sh", "build.gradle"))), Isolation.at(SandboxLevel.STRICT)).entries()
            .get(Path.of("").toAbsolutePath()).treatment());
    }

    @Test
    void inTheFolderOfALeagueABotHasOnlyItsFile() throws IOException {
        Path mine = program("night/bot", "");
        Path other = program("night/other", "");
        Files.writeString(folder.resolve("night/league.json"), "{}");
        assertEquals(Map.of(mine, StrictView.Treatment.SHOW), made(view(mine, other)));
        assertEquals(Set.of(), OwnFiles.of(Program.here(List.of(folder.resolve("night").toString()))));
    }

    /** The folder of the bot holds that of the league, in which is another bot of it. */
    @Test
    void whatTheIsolationHidesIsHiddenInItsOwnFolder() throws IOException {
        Path mine = program("bots/bot", "");
        Path league = program("bots/night/other", "").getParent();
        Path third = program("bots/third", "");
        StrictView view = StrictView.of(Program.here(List.of(mine.toString())), List.of(),
            Isolation.at(SandboxLevel.STRICT).hiding(List.of(league, third, mine)));
        assertEquals(Map.of(mine.getParent(), StrictView.Treatment.SHOW, league, StrictView.Treatment.HIDE_FOLDER,
            third, StrictView.Treatment.HIDE_FILE), made(view));
    }

    @Test
    void linksOnTheWayAreMadeAnew() throws IOException {
        Path real = program("real/mine/bot", "");
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("real"));
        Path file = Files.createSymbolicLink(folder.resolve("bot"), link.resolve("mine/bot"));
        assertEquals(Map.of(link, StrictView.Treatment.LINK, real.getParent(), StrictView.Treatment.SHOW),
            made(view(link.resolve("mine/bot"), real)));
        Map<Path, StrictView.Treatment> made = made(view(file, real, folder.resolve("bot")));
        assertEquals(StrictView.Treatment.SHOW, made.get(folder));
    }

    /** A copied interpreter finds its libraries beside the original, which {@code pyvenv.cfg} names. */
    @Test
    void aVirtualEnvironmentHasItsBase() throws IOException {
        Path base = program("python/bin/python3", "");
        Path copy = program("venv/bin/python3", "");
        Files.writeString(folder.resolve("venv/pyvenv.cfg"), "home = " + base.getParent() + "\nversion = 3.11\n");
        assertEquals(Set.of(folder.resolve("venv"), folder.resolve("python")),
            OwnFiles.of(Program.here(List.of(copy.toString()))));
    }

    @Test
    void whatBelongsToTheMachineIsNeverHidden() throws IOException {
        Path mine = program("mine/bot", "");
        StrictView view = StrictView.of(Program.here(List.of(mine.toString())),
            List.of(Program.here(List.of("/bin/sh", "/etc/passwd"))), Isolation.at(SandboxLevel.STRICT));
        assertTrue(view.entries().values().stream().noneMatch(entry -> entry.treatment()
            == StrictView.Treatment.HIDE_FILE || entry.treatment() == StrictView.Treatment.HIDE_FOLDER));
        assertTrue(view.shows(Path.of("/usr/bin/env")) && view.shows(Path.of("/etc/passwd")));
        for (String place : List.of("/srv", "/opt", "/var", "/home", "/etc/shadow", "/usr/local/src", "/sys", "/")) {
            assertFalse(view.shows(Path.of(place)), place);
        }
    }

    /** A bot that plays against a copy of itself, or is one of the bots whose files are hidden from all others. */
    @Test
    void filesThatAreListedAreTheBotsOwnWhoeverElseHasThem() throws IOException {
        Path home = Files.createDirectories(folder.resolve("listed"));
        Files.writeString(home.resolve("bot.py"), "");
        Path weights = Files.writeString(home.resolve("weights.txt"), "");
        Program bot = new Program(List.of("/bin/sh", "bot.py"), home, List.of("bot.py", "weights.txt"));
        StrictView view = StrictView.of(bot, List.of(bot),
            Isolation.at(SandboxLevel.STRICT).hidingFilesOf(List.of(bot)));
        assertTrue(view.shows(weights.toRealPath()), view.toString());
    }
}
