package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What belongs to a bot, and what it sees of others. */
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

    @Test
    void aProgramHasItsFolder() throws IOException {
        Path bot = program("mine/bot", "");
        assertEquals(Set.of(folder.resolve("mine")), OwnFiles.of(List.of(bot.toString())));
    }

    @Test
    void anInterpreterHasItsInstallationAndAScriptItsFolder() throws IOException {
        Path python = program("pyenv/shims/python", "");
        Path script = program("mine/bot.py", "");
        assertEquals(Set.of(folder.resolve("pyenv"), folder.resolve("mine")),
            OwnFiles.of(List.of(python.toString(), "-u", script.toString())));
    }

    @Test
    void linksAreFollowed() throws IOException {
        Path real = program("versions/3/bin/python", "");
        Path link = folder.resolve("venv/bin/python");
        Files.createDirectories(link.getParent());
        Files.createSymbolicLink(link, real);
        assertEquals(Set.of(folder.resolve("venv"), folder.resolve("versions/3")),
            OwnFiles.of(List.of(link.toString())));
    }

    @Test
    void theInterpreterInTheFirstLineIsLetIn() throws IOException {
        Path ruby = program("ruby/bin/ruby", "");
        Path bot = program("mine/bot", "#!" + ruby + " -w\nputs 1\n");
        assertEquals(Set.of(folder.resolve("mine"), folder.resolve("ruby")), OwnFiles.of(List.of(bot.toString())));
    }

    @Test
    void classPathsAreTakenApart() throws IOException {
        Path java = program("jdk/bin/java", "");
        Path jar = program("libs/a.jar", "");
        Path classes = Files.createDirectories(folder.resolve("classes"));
        assertEquals(Set.of(folder.resolve("jdk"), folder.resolve("libs"), classes),
            OwnFiles.of(List.of(java.toString(), "-cp", jar + ":" + classes, "Bot")));
    }

    @Test
    void aFolderThatHoldsHomesIsNeverABotsOwn() {
        Path home = OwnFiles.home();
        Set<Path> own = OwnFiles.of(List.of("/bin/sh", home.toString(), "/"));
        assertFalse(own.contains(home) || own.contains(Path.of("/")) || own.contains(home.getParent()), own.toString());
    }

    /** In a folder that is hidden anyway there is nothing to hide. */
    @Test
    void itsOwnFolderIsShownAndNoOther() throws IOException {
        Path mine = program("bots/mine/bot", "");
        Path other = program("bots/other/bot", "");
        StrictView view = StrictView.of(List.of(mine.toString()), List.of(List.of(other.toString())), List.of());
        assertEquals(Map.of(mine.getParent(), StrictView.Treatment.SHOW), view.treated());
    }

    @Test
    void foldersOfOtherBotsAreHiddenInWhatIsShown() throws IOException {
        Path mine = program("bots/mine/bot", "");
        Path other = program("bots/other/bot", "");
        StrictView view = StrictView.of(List.of(mine.toString()), List.of(List.of(other.toString())), List.of(folder));
        assertEquals(StrictView.Treatment.HIDE_FOLDER, view.treated().get(other.getParent()));
        assertEquals(StrictView.Treatment.SHOW, view.treated().get(mine.getParent()));
        assertEquals(folder, view.treated().keySet().iterator().next());
    }

    /** A bot inside the folder of another is shown in it, and not hidden with it. */
    @Test
    void aFolderInsideAnothersIsShown() throws IOException {
        Path other = program("bots/bot", "");
        Path mine = program("bots/mine/bot", "");
        StrictView view = StrictView.of(List.of(mine.toString()), List.of(List.of(other.toString())), List.of(folder));
        assertEquals(List.of(folder, other.getParent(), mine.getParent()), List.copyOf(view.treated().keySet()));
        assertEquals(List.of(StrictView.Treatment.SHOW, StrictView.Treatment.HIDE_FOLDER, StrictView.Treatment.SHOW),
            List.copyOf(view.treated().values()));
    }

    @Test
    void inOneFolderTheOthersProgramIsHidden() throws IOException {
        Path mine = program("bots/mine", "");
        Path other = program("bots/other", "");
        StrictView view = StrictView.of(List.of(mine.toString()), List.of(List.of(other.toString())), List.of());
        assertEquals(StrictView.Treatment.HIDE_FILE, view.treated().get(other));
        assertEquals(StrictView.Treatment.SHOW, view.treated().get(mine.getParent()));
        assertFalse(view.treated().containsKey(mine));
    }

    @Test
    void whatBelongsToTheMachineIsNeverHidden() throws IOException {
        Path mine = program("mine/bot", "");
        StrictView view = StrictView.of(List.of(mine.toString()), List.of(List.of("/bin/sh", "/etc/passwd")),
            List.of());
        assertEquals(Set.of(mine.getParent()), view.treated().keySet());
        assertTrue(view.hidden().contains(Path.of("/root")) || view.hidden().contains(Path.of("/home")));
        assertFalse(view.hidden().contains(Path.of("/tmp")));
    }
}
