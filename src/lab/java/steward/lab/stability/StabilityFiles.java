package steward.lab.stability;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.files.CsvFile;
import steward.files.OutputFiles;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.lab.trial.RunLength;
import steward.text.CsvRow;
import tools.jackson.core.JsonGenerator;

/**
 * The stability table in files: {@code stability.csv} grows by a line per row, {@code stability.json} is replaced by
 * one with the row. Both are whole after each row, so that an interrupted run leaves what was measured.
 */
public final class StabilityFiles implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "stability.csv";
    /** Name of the table for programs. */
    public static final String JSON = "stability.json";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON);

    private final Path json;
    private final CsvFile csv;
    private final RunLength size;
    private final List<StabilityRow> rows = new ArrayList<>();

    /**
     * Starts both files, replacing older ones.
     *
     * @param folder that exists
     * @throws IOException if a file cannot be written
     */
    public StabilityFiles(Path folder, RunLength size) throws IOException {
        json = folder.resolve(JSON);
        this.size = size;
        writeJson();
        csv = new CsvFile(folder.resolve(CSV), "case", "rung", "verdict", "seconds", "seen", "demand");
    }

    /** @throws UncheckedIOException if it cannot be written */
    public void add(StabilityRow row) {
        rows.add(row);
        try {
            csv.add(new CsvRow().text(row.name()).text(row.rung())
                .words(word(row), String.format(Locale.ROOT, "%.3f", row.seconds()))
                .text(row.seen().text()).text(row.demand()));
            writeJson();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private void writeJson() throws IOException {
        OutputFiles.replace(json, JsonObject.of(out -> write(out, size, rows)));
    }

    /** Writes the fields of the table's object. */
    public static void write(JsonGenerator out, RunLength size, List<StabilityRow> rows) {
        out.writeStringProperty("type", "stability");
        out.writeStringProperty("size", size.name().toLowerCase(Locale.ROOT));
        out.writeStringProperty("java", System.getProperty("java.version"));
        JsonObject.writeAll(out, "rows", rows, row -> {
            out.writeStringProperty("case", row.name());
            out.writeStringProperty("rung", row.rung());
            out.writeStringProperty("demand", row.demand());
            out.writeStringProperty("seen", row.seen().text());
            out.writeStringProperty("verdict", word(row));
            JsonNumbers.write(out, "seconds", row.seconds());
        });
    }

    private static String word(StabilityRow row) {
        return row.seen().verdict().name().toLowerCase(Locale.ROOT);
    }

    @Override
    public void close() {
        try {
            csv.close();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }
}
