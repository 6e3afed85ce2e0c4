package steward.lab.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.files.OutputFiles;
import steward.text.CsvRow;

/** A table on disk has every row that was added, at once and in UTF-8. */
class CsvFileTest {

    @TempDir
    private Path folder;

    @Test
    void theFileIsWholeAfterEachRow() throws IOException {
        Path file = Files.writeString(folder.resolve("table.csv"), "older and much longer than what comes");
        try (CsvFile table = new CsvFile(file, "name", "value")) {
            assertEquals("name,value\n", Files.readString(file));
            table.add(new CsvRow().text("Zürich").words("1"));
            assertEquals("name,value\n\"Zürich\",1\n", Files.readString(file));
            table.addAll(List.of(new CsvRow().words("a", "2"), new CsvRow().words("b", "3")));
            assertEquals("name,value\n\"Zürich\",1\na,2\nb,3\n", Files.readString(file));
        }
    }

    @Test
    void aReplacedFileIsTheNewOneAndNothingElse() throws IOException {
        Path file = Files.writeString(folder.resolve("table.json"), "old");
        OutputFiles.replace(file, new byte[] {'{', '}'});
        assertEquals("{}", Files.readString(file));
        assertEquals(List.of("table.json"), List.of(folder.toFile().list()));
    }
}
