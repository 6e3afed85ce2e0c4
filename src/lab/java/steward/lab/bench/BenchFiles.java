package steward.lab.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import steward.lab.chart.MeasuredTable;
import steward.report.Fields;
import steward.report.Table;

/** Writer of the bench's table to files, each row as soon as it is measured. The page comes last. */
public final class BenchFiles implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "bench.csv";
    /** Name of the table for programs. */
    public static final String JSON = "bench.json";
    /** Name of the page for people. */
    public static final String PAGE = "performance.md";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON, PAGE);

    private static final MathContext DIGITS = new MathContext(6);
    private static final Table<Row> COLUMNS = new Table<Row>().value("section", Row::section).value("name", Row::name)
        .value("unit", Row::unit).value("perSecond", row -> rounded(row.perSecond()))
        .value("nanos", row -> rounded(row.nanos())).value("ratio", row -> rounded(row.ratio()))
        .value("bytes", row -> rounded(row.bytes())).value("note", Row::note);

    private final Path folder;
    private final String machine;
    private final String date;
    private final double load = load();
    private final MeasuredTable<Row> table;

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
        table = new MeasuredTable<>(folder, "bench", facts(machine, date), COLUMNS);
    }

    private static Fields facts(String machine, String date) {
        return Fields.of("type", "bench", "machine", machine, "date", date);
    }

    /** Returns how many programs want a processor, the mean of a minute; negative where the system does not tell. */
    private static double load() {
        return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    }

    private static double rounded(double value) {
        return Double.isFinite(value) ? new BigDecimal(value).round(DIGITS).doubleValue() : value;
    }

    /** @throws java.io.UncheckedIOException if it cannot be written */
    public void add(Row row) {
        table.add(List.of(row));
    }

    /** The table's object. */
    public static Fields fields(String machine, String date, List<Row> rows) {
        return MeasuredTable.fields(facts(machine, date), COLUMNS, rows);
    }

    /** Writes the page; the run is over. */
    public void finish(List<Section> sections) {
        table.writing(() -> Files.writeString(folder.resolve(PAGE), PerformancePage.of(sections, table.rows(),
            machine, date, String.format(Locale.ROOT, "%.1f when it began and %.1f when it ended", load, load()))));
    }

    @Override
    public void close() {
        table.close();
    }
}
