package steward.lab.cli.shared;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import steward.files.InputException;

/** Tables that exist are kept unless told otherwise; files of an older run go when a new one begins. */
class TableFolderTest {

    @TempDir
    private Path folder;

    @Command
    private static final class Measuring {
        @Mixin
        private final TableFolder tables = new TableFolder();
    }

    private static TableFolder tables(String... options) {
        Measuring command = new Measuring();
        new CommandLine(command).parseArgs(options);
        return command.tables;
    }

    private String start(TableFolder tables) {
        return tables.start(folder, List.of("table.csv", "page.md"), () -> "started");
    }

    @Test
    void whatExistsIsKept() throws IOException {
        assertEquals("started", start(tables()));
        Files.writeString(folder.resolve("page.md"), "precious");
        assertEquals(folder.resolve("page.md") + ": exists already, and is kept",
            assertThrows(InputException.class, () -> start(tables())).getMessage());
        assertEquals("precious", Files.readString(folder.resolve("page.md")));
    }

    @Test
    void overwritingDeletesOlderFiles() throws IOException {
        Files.writeString(folder.resolve("table.csv"), "old");
        Files.writeString(folder.resolve("page.md"), "old");
        assertEquals("started", start(tables("--overwrite")));
        assertFalse(Files.exists(folder.resolve("table.csv")));
        assertFalse(Files.exists(folder.resolve("page.md")));
    }

    @Test
    void aFolderThatTakesNoFilesIsNamed() {
        assertEquals(folder + ": cannot be written into: full", assertThrows(InputException.class,
            () -> tables().start(folder, List.of(), () -> {
                throw new IOException("full");
            })).getMessage());
    }

    @Test
    void overwritingIsForAFolder() {
        tables().check(null);
        tables("--overwrite").check("results");
        assertEquals("--overwrite: expected --out with it",
            assertThrows(InputException.class, () -> tables("--overwrite").check(null)).getMessage());
    }
}
