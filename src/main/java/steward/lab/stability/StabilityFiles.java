package steward.lab.stability;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.game.JsonNumbers;
import steward.lab.trial.RunLength;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * The stability table in files: {@code stability.csv} grows by a line per row, {@code stability.json} is replaced by
 * one with the row. Both are whole after each row, so that an interrupted run leaves what was measured.
 */
public final class StabilityFiles implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "stability.csv";
    /** Name of the table for programs. */
    public static final String JSON = "stability.json";

    private final Path json;
    private final OutputStream csv;
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
        csv = Files.newOutputStream(folder.resolve(CSV));
        csv.write("case,rung,verdict,seconds,seen,demand\n".getBytes(StandardCharsets.UTF_8));
    }

    /** @throws UncheckedIOException if it cannot be written */
    public void add(StabilityRow row) {
        rows.add(row);
        String line = String.join(",", quote(row.name()), quote(row.rung()), word(row),
            String.format(Locale.ROOT, "%.3f", row.seconds()), quote(row.seen().text()), quote(row.demand()));
        try {
            csv.write((line + "\n").getBytes(StandardCharsets.UTF_8));
            writeJson();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private void writeJson() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            out.writeStartObject();
            out.writeStringProperty("type", "stability");
            out.writeStringProperty("size", size.name().toLowerCase(Locale.ROOT));
            out.writeStringProperty("java", System.getProperty("java.version"));
            out.writeName("rows");
            out.writeStartArray();
            for (StabilityRow row : rows) {
                out.writeStartObject();
                out.writeStringProperty("case", row.name());
                out.writeStringProperty("rung", row.rung());
                out.writeStringProperty("demand", row.demand());
                out.writeStringProperty("seen", row.seen().text());
                out.writeStringProperty("verdict", word(row));
                JsonNumbers.write(out, "seconds", row.seconds());
                out.writeEndObject();
            }
            out.writeEndArray();
            out.writeEndObject();
        }
        Path part = json.resolveSibling(JSON + ".part");
        Files.write(part, bytes.toByteArray());
        Files.move(part, json, StandardCopyOption.REPLACE_EXISTING);
    }

    private static String word(StabilityRow row) {
        return row.seen().verdict().name().toLowerCase(Locale.ROOT);
    }

    private static String quote(String text) {
        return '"' + text.replace("\"", "\"\"") + '"';
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
