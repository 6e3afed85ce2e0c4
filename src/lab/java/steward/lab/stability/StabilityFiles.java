package steward.lab.stability;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import steward.lab.chart.MeasuredTable;
import steward.lab.chart.MeasuredTable.Column;
import tools.jackson.core.JsonGenerator;

/** Writer of the stability table to files, each row as soon as it is known. */
public final class StabilityFiles {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "stability.csv";
    /** Name of the table for programs. */
    public static final String JSON = "stability.json";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON);

    private StabilityFiles() { }

    private static List<Column<StabilityRow>> columns(StabilityRun run) {
        return List.of(new Column<>("case", StabilityRow::name), new Column<>("rung", StabilityRow::rung),
            new Column<>("verdict", row -> row.seen().verdict()),
            new Column<>("seconds", row -> new BigDecimal(row.seconds()).setScale(3, RoundingMode.HALF_UP)
                .doubleValue()),
            new Column<>("seen", row -> row.seen().text()), new Column<>("demand", StabilityRow::demand),
            new Column<>("length", row -> run.length()), new Column<>("date", row -> run.date()),
            new Column<>("version", row -> run.version()), new Column<>("machine", row -> run.machine()));
    }

    private static Map<String, String> facts(StabilityRun run) {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("type", "stability");
        facts.put("size", run.length().name().toLowerCase(Locale.ROOT));
        facts.put("date", run.date());
        facts.put("version", run.version());
        facts.put("machine", run.machine());
        facts.put("java", System.getProperty("java.version"));
        return facts;
    }

    /**
     * Starts the tables, replacing older ones.
     *
     * @param folder that exists
     * @throws IOException if a file cannot be written
     */
    public static MeasuredTable<StabilityRow> start(Path folder, StabilityRun run) throws IOException {
        return new MeasuredTable<>(folder, facts(run), columns(run));
    }

    /** Writes the fields of the table's object. */
    public static void write(JsonGenerator out, StabilityRun run, List<StabilityRow> rows) {
        MeasuredTable.write(out, facts(run), columns(run), rows);
    }
}
