package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Calls that cannot be used play, write and lose nothing. Their messages are held to the letter by
 * {@link BadInputTableTest}.
 */
class BadInputTest {

    @TempDir
    private Path folder;

    private static void refused(String message, String... arguments) {
        Cli.run(arguments).assertRefused(message);
    }

    @Test
    void anOutputThatCannotBeWrittenIsFoundBeforeTheMatch() throws IOException {
        Path played = folder.resolve("played");
        String bot = "sh -c 'touch " + played + "'";
        for (String out : List.of(folder + "/missing/x.jsonl", folder.toString(), "/proc/x.jsonl")) {
            refused(out, "match", "--scene", "duel", "--bot", bot, "--bot", bot, "--out", out);
        }
        assertFalse(Files.exists(played));
    }

    @Test
    void anOutputFolderWithoutPermissionIsFoundBeforeTheMatch() throws IOException {
        Path closed = Files.createDirectory(folder.resolve("closed"));
        assertTrue(closed.toFile().setWritable(false));
        assumeTrue(!Files.isWritable(closed), "this user may write everywhere");
        refused("no permission", "match", "--bot", "sh", "--bot", "sh", "--out", closed + "/x.jsonl");
        refused("no permission", "match", "--bot", "sh", "--bot", "sh", "--out", closed.toString(), "--games", "2");
    }

    @Test
    void aReplayThatExistsIsKept() throws IOException {
        Path file = Files.writeString(folder.resolve("x.jsonl"), "precious");
        refused("exists already, and is kept", "match", "--bot", "sh", "--bot", "sh", "--out", file.toString());
        Path second = Files.writeString(folder.resolve("game-0002.jsonl"), "precious");
        refused(second + ": exists already", "match", "--bot", "sh", "--bot", "sh", "--out", folder.toString(),
            "--games", "2");
        refused("found a file, expected a folder", "match", "--bot", "sh", "--bot", "sh", "--out", file.toString(),
            "--games", "2");
        assertEquals("precious", Files.readString(file));
        assertEquals("precious", Files.readString(second));
        assertFalse(Files.exists(folder.resolve("game-0001.jsonl")));
    }

    @Test
    void aRefusedCallLeavesNoFile() {
        Path file = folder.resolve("x.jsonl");
        refused("there is no program", "match", "--bot", "sh", "--bot", "no-such-program", "--out", file.toString());
        assertFalse(Files.exists(file));
    }
}
