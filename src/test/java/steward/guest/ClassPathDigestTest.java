package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The digest of a class path covers what the JVM loads, links included. */
class ClassPathDigestTest {

    @TempDir
    private Path folder;

    private static String digest(Path entry) {
        return new ClassPathDigest(List.of(entry.toString())).text();
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
}
