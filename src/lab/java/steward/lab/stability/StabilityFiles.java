package steward.lab.stability;

import java.awt.AWTError;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.files.CsvFile;
import steward.files.OutputFiles;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.text.CsvRow;
import tools.jackson.core.JsonGenerator;

/**
 * The stability table in files: {@code stability.csv} grows by a line per row, {@code stability.json} is replaced by
 * one with the row. Both are whole after each row, so that an interrupted run leaves what was measured. The page with
 * its picture comes last.
 */
public final class StabilityFiles implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "stability.csv";
    /** Name of the table for programs. */
    public static final String JSON = "stability.json";
    /** Name of the page. */
    public static final String PAGE = "stability.md";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON, PAGE, TruePathPlot.PNG, TruePathPlot.DARK_PNG);

    private final Path folder;
    private final CsvFile csv;
    private final StabilityRun run;
    private final List<StabilityRow> rows = new ArrayList<>();

    /**
     * Starts the tables, replacing older ones.
     *
     * @param folder that exists
     * @throws IOException if a file cannot be written
     */
    public StabilityFiles(Path folder, StabilityRun run) throws IOException {
        this.folder = folder;
        this.run = run;
        writeJson();
        csv = new CsvFile(folder.resolve(CSV), "case", "rung", "verdict", "seconds", "seen", "demand", "length",
            "date", "version", "machine");
    }

    /** @throws UncheckedIOException if it cannot be written */
    public void add(StabilityRow row) {
        rows.add(row);
        try {
            csv.add(new CsvRow().text(row.name()).text(row.rung())
                .words(word(row), String.format(Locale.ROOT, "%.3f", row.seconds()))
                .text(row.seen().text()).text(row.demand()).words(length(run), run.date(), run.version())
                .text(run.machine()));
            writeJson();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private void writeJson() throws IOException {
        OutputFiles.replace(folder.resolve(JSON), JsonObject.of(out -> write(out, run, rows)));
    }

    /** Writes the fields of the table's object. */
    public static void write(JsonGenerator out, StabilityRun run, List<StabilityRow> rows) {
        out.writeStringProperty("type", "stability");
        out.writeStringProperty("size", length(run));
        out.writeStringProperty("date", run.date());
        out.writeStringProperty("version", run.version());
        out.writeStringProperty("machine", run.machine());
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

    /**
     * Writes the page and its picture; nothing if there are no rows.
     *
     * @return {@code null}, or why there is no picture: some installations of Java come without fonts
     * @throws UncheckedIOException if a file cannot be written
     */
    public String finish() {
        if (rows.isEmpty()) {
            return null;
        }
        try {
            Files.writeString(folder.resolve(PAGE), StabilityPage.text(run, rows));
            TruePathPlot.write(rows, folder);
            return null;
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        } catch (RuntimeException | LinkageError | InternalError | AWTError problem) {
            return problem.toString();
        }
    }

    private static String length(StabilityRun run) {
        return run.length().name().toLowerCase(Locale.ROOT);
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
