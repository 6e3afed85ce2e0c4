package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.files.InputException;

/** The file of a replay is there from its first line on: who is killed before leaves no empty one. */
class ReplayFileTest {

    private static final byte[] LINE = "a line\n".getBytes(StandardCharsets.UTF_8);

    @TempDir
    private Path folder;
    private Path path;

    @BeforeEach
    void name() {
        path = folder.resolve("game.jsonl");
    }

    private String content() throws IOException {
        return Files.readString(path);
    }

    @Test
    void itIsMadeWithItsFirstLine() throws IOException {
        ReplayFile file = new ReplayFile(path, false);
        assertFalse(Files.exists(path), "before the first line");
        assertFalse(file.exists());
        file.write(LINE, 0, LINE.length);
        file.flush();
        assertEquals("a line\n", content());
        assertTrue(file.exists());
        file.close();
        assertEquals("a line\n", content());
    }

    @Test
    void whatIsReplacedStaysUntilThen() throws IOException {
        Files.writeString(path, "the old one\n");
        try (ReplayFile unused = new ReplayFile(path, true)) {
            assertFalse(unused.exists());
            unused.flush();
        }
        assertEquals("the old one\n", content());
        try (ReplayFile file = new ReplayFile(path, true)) {
            file.write(LINE, 0, LINE.length);
        }
        assertEquals("a line\n", content());
    }

    @Test
    void withoutALineNoFileIsLeft() {
        ReplayFile file = new ReplayFile(path, false);
        file.close();
        file.removeIfEmpty();
        assertFalse(Files.exists(path));
        assertFalse(file.isBroken());
    }

    /** Two programs are told the same name: the file of the one that is later is not made, that of the other stays. */
    @Test
    void aFileThatAnotherHasMadeMeanwhileIsKept() throws IOException {
        ReplayFile file = new ReplayFile(path, false);
        Files.writeString(path, "another's\n");
        file.write(LINE, 0, LINE.length);
        file.close();
        assertTrue(file.isBroken());
        file.removeIfEmpty();
        file.remove();
        assertEquals("another's\n", content());
        assertTrue(file.problem().startsWith(path + ": cannot be written: it exists by now"), file.problem());
    }

    @Test
    void whatCannotBeMadeIsRefusedBeforeTheMatch() throws IOException {
        Files.writeString(path, "");
        assertRefused(path, "exists already, and is kept");
        assertRefused(folder, "found a folder");
        assertRefused(folder.resolve("none/game.jsonl"), "there is no folder " + folder.resolve("none"));
        assertRefused(path.resolve("game.jsonl"), path + " is not a folder");
        assertRefused(folder.resolve("x".repeat(300)), "name too long");
    }

    private static void assertRefused(Path path, String why) {
        String told = assertThrows(InputException.class, () -> new ReplayFile(path, false).close()).getMessage();
        assertTrue(told.contains(why), told);
    }
}
