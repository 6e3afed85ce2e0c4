package steward.lab.chart;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import steward.text.CsvRow;

/** A CSV table that grows row by row; each added row is in the file at once, whatever happens next. */
final class CsvFile implements AutoCloseable {

    private final OutputStream out;

    /**
     * Starts the file with the names of its columns, replacing an older one.
     *
     * @throws IOException if it cannot be written
     */
    CsvFile(Path file, String... columns) throws IOException {
        out = Files.newOutputStream(file);
        add(new CsvRow().words(columns));
    }

    /** @throws IOException if it cannot be written */
    void add(CsvRow row) throws IOException {
        addAll(List.of(row));
    }

    /**
     * Adds rows that belong together in one go.
     *
     * @throws IOException if they cannot be written
     */
    void addAll(List<CsvRow> rows) throws IOException {
        StringBuilder lines = new StringBuilder();
        rows.forEach(row -> lines.append(row.line()));
        out.write(lines.toString().getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
