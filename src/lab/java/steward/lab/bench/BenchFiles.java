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
import steward.text.TextFormat;

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
    /** Columns of the table; people see them without the section. */
    public static final Table<Row> COLUMNS = new Table<Row>().value("section", Row::section).value("name", Row::name)
        .left(" ".repeat(44), 0, row -> "  " + row.name()).value("unit", Row::unit)
        .value("perSecond", row -> rounded(row.perSecond()))
        .right("a second", 14, row -> String.format(Locale.ROOT, "%,.0f", row.perSecond()))
        .value("nanos", row -> rounded(row.nanos())).right("each", 12, row -> PerformancePage.time(row.nanos()))
        .value("ratio", row -> rounded(row.ratio())).right("ratio", 9, row -> TextFormat.fixed(row.ratio(), 2))
        .value("bytes", row -> rounded(row.bytes())).right("bytes", 9, row -> TextFormat.fixed(row.bytes(), 0))
        .value("note", Row::note).left("", 2, Row::note);

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
