package steward.lab.tradeoff.report;

import java.awt.AWTError;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.files.CsvFile;
import steward.files.OutputFiles;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.lab.tradeoff.TradeoffHeadings;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;
import tools.jackson.core.JsonGenerator;

/**
 * The trade-off in files. {@code tradeoff.csv} grows by the rows of each scene, {@code tradeoff.json} is replaced by
 * one with them: both are whole after each scene, so that an interrupted run leaves what was measured. The pictures and
 * the page that shows them come last.
 */
public final class TradeoffReport implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "tradeoff.csv";
    /** Name of the table for programs. */
    public static final String JSON = "tradeoff.json";
    /** Name of the page that shows the plot. */
    public static final String PAGE = "tradeoff.md";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON, TradeoffPlot.SVG, TradeoffPlot.DARK_SVG,
        TradeoffPlot.PNG, TradeoffPlot.DARK_PNG, TradeoffPlot.ALL_PNG, TradeoffPlot.ALL_DARK_PNG, PAGE);

    private final Path folder;
    private final String machine;
    private final String date;
    private final CsvFile csv;
    private final List<TradeoffRow> rows = new ArrayList<>();
    private final List<TradeoffHeadings> headings = new ArrayList<>();

    /**
     * Starts the tables, replacing older ones.
     *
     * @param folder that exists
     * @param date   of the run, as year-month-day
     * @throws IOException if a file cannot be written
     */
    public TradeoffReport(Path folder, String machine, String date) throws IOException {
        this.folder = folder;
        this.machine = machine;
        this.date = date;
        writeJson();
        csv = new CsvFile(folder.resolve(CSV), TradeoffFields.names());
    }

    /** Returns the measurements so far. */
    public TradeoffResult result() {
        return new TradeoffResult(machine, date, rows, headings);
    }

    /** @throws UncheckedIOException if it cannot be written */
    public void add(List<TradeoffRow> more) {
        rows.addAll(more);
        try {
            csv.addAll(more.stream().map(TradeoffFields::csv).toList());
            writeJson();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** @throws UncheckedIOException if it cannot be written */
    public void addHeadings(TradeoffHeadings more) {
        headings.add(more);
        try {
            writeJson();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /**
     * Writes the page and the plot; nothing if there are no rows.
     *
     * @return {@code null}, or why there is no plot: some installations of Java come without fonts
     * @throws UncheckedIOException if a file cannot be written
     */
    public String finish() {
        if (rows.isEmpty()) {
            return null;
        }
        try {
            Files.writeString(folder.resolve(PAGE), TradeoffPage.text(result()));
            TradeoffPlot.write(result(), folder);
            return null;
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        } catch (RuntimeException | LinkageError | InternalError | AWTError problem) {
            return problem.toString();
        }
    }

    private void writeJson() throws IOException {
        OutputFiles.replace(folder.resolve(JSON), JsonObject.of(out -> write(out, result())));
    }

    /** Writes the fields of the result's object. */
    public static void write(JsonGenerator out, TradeoffResult result) {
        out.writeStringProperty("type", "tradeoff");
        out.writeStringProperty("machine", result.machine());
        out.writeStringProperty("date", result.date());
        JsonObject.writeAll(out, "rows", result.rows(), row ->
            TradeoffFields.ALL.forEach(field -> write(out, field.name(), field.value().apply(row))));
        JsonObject.writeAll(out, "headings", result.headings(), each -> {
            out.writeStringProperty("headings", each.headings());
            out.writeNumberProperty("podTurns", each.podTurns());
            out.writeNumberProperty("differing", each.differing());
            JsonNumbers.write(out, "nanosAngles", each.nanosAngles());
            JsonNumbers.write(out, "nanosVector", each.nanosVector());
        });
    }

    private static void write(JsonGenerator out, String name, Object value) {
        if (value instanceof String text) {
            out.writeStringProperty(name, text);
        } else if (value instanceof Boolean flag) {
            out.writeBooleanProperty(name, flag);
        } else if (value instanceof Double number) {
            JsonNumbers.writeOrNull(out, name, Double.isFinite(number) ? number : Double.NaN);
        } else {
            out.writeNumberProperty(name, ((Number) value).longValue());
        }
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
