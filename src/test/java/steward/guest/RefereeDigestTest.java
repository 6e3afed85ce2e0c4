package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The digest of a referee covers what the JVM loads, links included, and what a command names. */
class RefereeDigestTest {

    @TempDir
    private Path folder;

    private static String digest(Path entry) {
        return digest(List.of(), List.of(entry.toString()));
    }

    private static String digest(List<String> command, List<String> classPath) {
        return new RefereeDigest(new GuestProgram(command, classPath, null, null, Map.of(), SoloTests.NONE, Map.of(), 1,
            Set.of())).text();
    }

    @Test
    void aLinkedFolderCountsAsTheFolder() throws IOException {
        Path classes = Files.createDirectories(folder.resolve("built/classes"));
        Path file = Files.writeString(classes.resolve("Referee.class"), "one");
        Path link = Files.createSymbolicLink(folder.resolve("link"), classes);
        String before = digest(link);
        assertEquals(digest(classes), before);
        Files.writeString(file, "two");
        assertNotEquals(before, digest(link));
    }

    @Test
    void aCommandCountsByTheFilesThatItNamesWhereverTheyAre() throws IOException {
        Path script = Files.writeString(folder.resolve("referee.py"), "one");
        Path moved = Files.copy(script, Files.createDirectory(folder.resolve("elsewhere")).resolve("moved.py"));
        List<String> command = List.of("python3", script.toString(), "mode");
        String before = digest(command, List.of());
        assertEquals(before, digest(List.of("pypy", moved.toString()), List.of()));
        Files.writeString(script, "two");
        assertNotEquals(before, digest(command, List.of()));
        assertNull(digest(List.of("python3", "-m", "referee", "no \0 path"), List.of()));
    }
}
