package steward.lab.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.report.Fields;
import steward.report.Table;

/** Files of measurements: each has every row that was added, at once and in UTF-8. */
class MeasuredTableTest {

    private record Row(String name, double value) { }

    @TempDir
    private Path folder;

    @Test
    void bothFilesAreWholeAfterEachRow() throws IOException {
        Path csv = Files.writeString(folder.resolve("few.csv"), "older and much longer than what comes");
        Path json = folder.resolve("few.json");
        try (MeasuredTable<Row> table = new MeasuredTable<>(folder, "few", Fields.of("type", "few"),
            new Table<Row>().value("name", Row::name).value("value", Row::value))) {
            assertEquals("name,value\n", Files.readString(csv));
            assertEquals("{\"type\":\"few\",\"rows\":[]}", Files.readString(json));
            table.add(List.of(new Row("Zürich", 1.5)));
            assertEquals("name,value\n\"Zürich\",1.5\n", Files.readString(csv));
            table.add(List.of(new Row("a", Double.NaN), new Row("b", 3)));
            assertEquals("name,value\n\"Zürich\",1.5\n\"a\",\n\"b\",3.0\n", Files.readString(csv));
            assertEquals("{\"type\":\"few\",\"rows\":[{\"name\":\"Zürich\",\"value\":1.5},"
                + "{\"name\":\"a\",\"value\":null},{\"name\":\"b\",\"value\":3}]}", Files.readString(json));
        }
    }
}
