package steward.files;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that replace others. */
class OutputFilesTest {

    @TempDir
    private Path folder;

    @Test
    void aReplacedFileIsTheNewOneAndNothingElse() throws IOException {
        Path file = Files.writeString(folder.resolve("table.json"), "old");
        OutputFiles.replace(file, new byte[] {'{', '}'});
        assertEquals("{}", Files.readString(file));
        assertEquals(List.of("table.json"), List.of(folder.toFile().list()));
    }
}
