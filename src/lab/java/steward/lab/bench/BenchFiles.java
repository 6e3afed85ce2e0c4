package steward.lab.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import steward.lab.chart.MeasuredTable;
import steward.lab.chart.MeasuredTable.Column;
import tools.jackson.core.JsonGenerator;

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
    private static final List<Column<Row>> COLUMNS = List.of(new Column<>("section", Row::section),
        new Column<>("name", Row::name), new Column<>("unit", Row::unit),
        new Column<>("perSecond", row -> rounded(row.perSecond())), new Column<>("nanos", row -> rounded(row.nanos())),
        new Column<>("ratio", row -> rounded(row.ratio())), new Column<>("bytes", row -> rounded(row.bytes())),
        new Column<>("note", Row::note));

    private final Path folder;
    private final Map<String, String> facts;
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
        facts = facts(machine, date);
        table = new MeasuredTable<>(folder, facts, COLUMNS);
    }

    private static Map<String, String> facts(String machine, String date) {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("type", "bench");
        facts.put("machine", machine);
        facts.put("date", date);
        return facts;
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

    /** Writes the fields of the table's object. */
    public static void write(JsonGenerator out, String machine, String date, List<Row> rows) {
        MeasuredTable.write(out, facts(machine, date), COLUMNS, rows);
    }

    /** Writes the page; the run is over. */
    public void finish(List<Section> sections) {
        table.writing(() -> Files.writeString(folder.resolve(PAGE), PerformancePage.of(sections, table.rows(),
            facts.get("machine"), facts.get("date"),
            String.format(Locale.ROOT, "%.1f when it began and %.1f when it ended", load, load()))));
    }

    @Override
    public void close() {
        table.close();
    }
}
