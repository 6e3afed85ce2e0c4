package steward.lab.stability;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.List;
import steward.lab.chart.MeasuredTable;
import steward.report.Fields;
import steward.report.Table;

/** Writer of the stability table to files, each row as soon as it is known. */
public final class StabilityFiles {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "stability.csv";
    /** Name of the table for programs. */
    public static final String JSON = "stability.json";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON);

    private StabilityFiles() { }

    private static Table<StabilityRow> columns(StabilityRun run) {
        return new Table<StabilityRow>().value("case", StabilityRow::name).value("rung", StabilityRow::rung)
            .value("verdict", row -> row.seen().verdict())
            .value("seconds", row -> new BigDecimal(row.seconds()).setScale(3, RoundingMode.HALF_UP).doubleValue())
            .value("seen", row -> row.seen().text()).value("demand", StabilityRow::demand)
            .value("length", row -> run.length()).value("date", row -> run.date())
            .value("version", row -> run.version()).value("machine", row -> run.machine());
    }

    private static Fields facts(StabilityRun run) {
        return Fields.of("type", "stability", "size", run.length(), "date", run.date(), "version", run.version(),
            "machine", run.machine(), "java", System.getProperty("java.version"));
    }

    /**
     * Starts the tables, replacing older ones.
     *
     * @param folder that exists
     * @throws IOException if a file cannot be written
     */
    public static MeasuredTable<StabilityRow> start(Path folder, StabilityRun run) throws IOException {
        return new MeasuredTable<>(folder, "stability", facts(run), columns(run));
    }

    /** The table's object. */
    public static Fields fields(StabilityRun run, List<StabilityRow> rows) {
        return MeasuredTable.fields(facts(run), columns(run), rows);
    }
}
