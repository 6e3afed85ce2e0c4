package steward.lab.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import steward.files.CsvFile;
import steward.files.OutputFiles;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.text.CsvRow;
import tools.jackson.core.JsonGenerator;

/**
 * The table in files. {@code bench.csv} grows row by row, {@code bench.json} is replaced by one with the new row: both
 * are whole after each, so that an interrupted run leaves what was measured. The page comes last.
 */
public final class BenchFiles implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "bench.csv";
    /** Name of the table for programs. */
    public static final String JSON = "bench.json";
    /** Name of the page for people. */
    public static final String PAGE = "performance.md";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON, PAGE);

    private final Path folder;
    private final String machine;
    private final String date;
    private final double load = load();
    private final CsvFile csv;
    private final List<Row> rows = new ArrayList<>();

    /**
     * Starts the tables, replacing older ones.
     *
     * @param folder  that exists
     * @param machine what is measured on
     * @param date    of the run, as year-month-day
     * @throws IOException if a file cannot be written
     */
    public BenchFiles(Path folder, String machine, String date) throws IOException {
        this.folder = folder;
        this.machine = machine;
        this.date = date;
        csv = new CsvFile(folder.resolve(CSV),
            "section", "name", "unit", "perSecond", "nanos", "ratio", "bytes", "note");
        writeJson();
    }

    /** Returns how many programs want a processor, the mean of a minute; negative where the system does not tell. */
    private static double load() {
        return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    }

    /** @throws UncheckedIOException if it cannot be written */
    public void add(Row row) {
        rows.add(row);
        try {
            csv.add(new CsvRow().words(row.section()).text(row.name()).words(row.unit(), number(row.perSecond()),
                number(row.nanos()), number(row.ratio()), number(row.bytes())).text(row.note()));
            writeJson();
        } catch (IOException problem) {
            throw unwritable(problem);
        }
    }

    private UncheckedIOException unwritable(IOException problem) {
        return new UncheckedIOException(folder + ": cannot be written into: " + problem.getMessage(), problem);
    }

    private static String number(double value) {
        return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.6g", value);
    }

    /** Writes the fields of the table's object. */
    public static void write(JsonGenerator out, String machine, String date, List<Row> rows) {
        out.writeStringProperty("type", "bench");
        out.writeStringProperty("machine", machine);
        out.writeStringProperty("date", date);
        JsonObject.writeAll(out, "rows", rows, row -> {
            out.writeStringProperty("section", row.section());
            out.writeStringProperty("name", row.name());
            out.writeStringProperty("unit", row.unit());
            JsonNumbers.writeOrNull(out, "perSecond", row.perSecond());
            JsonNumbers.writeOrNull(out, "nanos", row.nanos());
            JsonNumbers.writeOrNull(out, "ratio", row.ratio());
            JsonNumbers.writeOrNull(out, "bytes", row.bytes());
            out.writeStringProperty("note", row.note());
        });
    }

    private void writeJson() throws IOException {
        byte[] object = JsonObject.of(out -> write(out, machine, date, rows));
        byte[] line = Arrays.copyOf(object, object.length + 1);
        line[object.length] = '\n';
        OutputFiles.replace(folder.resolve(JSON), line);
    }

    /** Writes the page; the run is over. */
    public void finish(List<Section> sections) {
        try {
            Files.writeString(folder.resolve(PAGE), PerformancePage.of(sections, rows,
                machine, date, String.format(Locale.ROOT, "%.1f when it began and %.1f when it ended", load, load())));
        } catch (IOException problem) {
            throw unwritable(problem);
        }
    }

    @Override
    public void close() {
        try {
            csv.close();
        } catch (IOException problem) {
            throw unwritable(problem);
        }
    }
}
