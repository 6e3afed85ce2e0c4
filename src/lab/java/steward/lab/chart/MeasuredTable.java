package steward.lab.chart;

import java.awt.AWTError;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import steward.files.CsvFile;
import steward.files.OutputFiles;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.text.CsvRow;
import tools.jackson.core.JsonGenerator;

/**
 * Table of measurements, written to two files. {@code NAME.csv} grows by each row; {@code NAME.json} is replaced by one
 * with the row. Both are complete after each row, so that an interrupted run leaves its measurements.
 *
 * @param <R> a row
 */
public final class MeasuredTable<R> implements AutoCloseable {

    /**
     * A column, with one name in CSV and JSON.
     *
     * @param value a text, a word as a constant of an enumeration, a boolean, an integer, or a double: one that is not
     *              finite is empty in CSV and null in JSON
     */
    public record Column<R>(String name, Function<R, Object> value) { }

    /** Work that writes files. */
    @FunctionalInterface
    public interface Writing {

        void write() throws IOException;
    }

    private final Path folder;
    private final Path json;
    private final List<Column<R>> columns;
    private final Map<String, String> facts;
    private final CsvFile csv;
    private final List<R> rows = new ArrayList<>();

    /**
     * Starts the files, replacing older ones.
     *
     * @param folder that exists
     * @param facts  of the run, with its {@code type} first, which is the name of the files
     * @throws IOException if a file cannot be written
     */
    public MeasuredTable(Path folder, Map<String, String> facts, List<Column<R>> columns) throws IOException {
        this.folder = folder;
        this.columns = columns;
        this.facts = facts;
        String name = facts.get("type");
        json = folder.resolve(name + ".json");
        writeJson();
        csv = new CsvFile(folder.resolve(name + ".csv"), columns.stream().map(Column::name).toArray(String[]::new));
    }

    /** The rows so far. */
    public List<R> rows() {
        return List.copyOf(rows);
    }

    /** @throws UncheckedIOException if they cannot be written */
    public void add(List<R> more) {
        rows.addAll(more);
        writing(() -> {
            csv.addAll(more.stream().map(this::cells).toList());
            writeJson();
        });
    }

    /** @throws UncheckedIOException with the folder, in place of an {@link IOException} */
    public void writing(Writing files) {
        try {
            files.write();
        } catch (IOException problem) {
            throw new UncheckedIOException(folder + ": cannot be written into: " + problem.getMessage(), problem);
        }
    }

    /**
     * Writes pictures; nothing if there are no rows.
     *
     * @return {@code null}, or why there is no picture: some installations of Java come without fonts
     * @throws UncheckedIOException if a file cannot be written
     */
    public String finish(Writing pictures) {
        try {
            if (!rows.isEmpty()) {
                writing(pictures);
            }
            return null;
        } catch (UncheckedIOException problem) {
            throw problem;
        } catch (RuntimeException | LinkageError | InternalError | AWTError problem) {
            return problem.toString();
        }
    }

    private CsvRow cells(R row) {
        CsvRow cells = new CsvRow();
        for (Column<R> column : columns) {
            Object value = column.value().apply(row);
            if (value instanceof String text) {
                cells.text(text);
            } else {
                cells.words(value instanceof Double number && !Double.isFinite(number) ? "" : word(value));
            }
        }
        return cells;
    }

    private static String word(Object value) {
        return value instanceof Enum ? value.toString().toLowerCase(Locale.ROOT) : value.toString();
    }

    private void writeJson() throws IOException {
        OutputFiles.replace(json, JsonObject.of(out -> write(out, facts, columns, rows)));
    }

    /** Writes the fields of a table's object: the facts, and the {@code rows}. */
    public static <R> void write(JsonGenerator out, Map<String, String> facts, List<Column<R>> columns, List<R> rows) {
        facts.forEach(out::writeStringProperty);
        JsonObject.writeAll(out, "rows", rows,
            row -> columns.forEach(column -> write(out, column.name(), column.value().apply(row))));
    }

    private static void write(JsonGenerator out, String name, Object value) {
        if (value instanceof Boolean flag) {
            out.writeBooleanProperty(name, flag);
        } else if (value instanceof Double number) {
            JsonNumbers.writeOrNull(out, name, Double.isFinite(number) ? number : Double.NaN);
        } else if (value instanceof Number number) {
            out.writeNumberProperty(name, number.longValue());
        } else {
            out.writeStringProperty(name, value instanceof String text ? text : word(value));
        }
    }

    @Override
    public void close() {
        writing(csv::close);
    }
}
