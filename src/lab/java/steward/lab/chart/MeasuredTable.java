package steward.lab.chart;

import java.awt.AWTError;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.files.OutputFiles;
import steward.json.JsonObject;
import steward.report.Fields;
import steward.report.Table;

/**
 * Table of measurements, written to two files. {@code NAME.csv} grows by each row; {@code NAME.json} is replaced by one
 * with the row. Both are complete after each row, so that an interrupted run leaves its measurements.
 *
 * @param <R> a row
 */
public final class MeasuredTable<R> implements AutoCloseable {

    /** Work that writes files. */
    @FunctionalInterface
    public interface Writing {

        void write() throws IOException;
    }

    private final Path folder;
    private final Path json;
    private final Table<R> columns;
    private final Fields facts;
    private final OutputStream csv;
    private final List<R> rows = new ArrayList<>();

    /**
     * Starts the files, replacing older ones.
     *
     * @param folder that exists
     * @param name   of the files
     * @param facts  of the run
     * @throws IOException if a file cannot be written
     */
    public MeasuredTable(Path folder, String name, Fields facts, Table<R> columns) throws IOException {
        this.folder = folder;
        this.columns = columns;
        this.facts = facts;
        json = folder.resolve(name + ".json");
        writeJson();
        csv = Files.newOutputStream(folder.resolve(name + ".csv"));
        csv.write(columns.csv(rows, String::valueOf, true).getBytes(StandardCharsets.UTF_8));
    }

    /** The rows so far. */
    public List<R> rows() {
        return List.copyOf(rows);
    }

    /** @throws UncheckedIOException if they cannot be written */
    public void add(List<R> more) {
        rows.addAll(more);
        writing(() -> {
            csv.write(columns.csvRows(more, String::valueOf, true).getBytes(StandardCharsets.UTF_8));
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

    private void writeJson() throws IOException {
        OutputFiles.replace(json, JsonObject.of(fields(facts, columns, rows)::write));
    }

    /** The facts, and the {@code rows}. */
    public static <R> Fields fields(Fields facts, Table<R> columns, List<R> rows) {
        return Fields.of().and(facts).with("rows", columns.json(rows));
    }

    @Override
    public void close() {
        writing(csv::close);
    }
}
