package steward.lab.tradeoff.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import steward.lab.chart.MeasuredTable;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;
import steward.report.Fields;
import steward.report.Table;

/** Report of the measured trade-off in files, the rows of a scene together. The pictures come last. */
public final class TradeoffReport implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "tradeoff.csv";
    /** Name of the table for programs. */
    public static final String JSON = "tradeoff.json";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON,
        TradeoffPlot.PNG, TradeoffPlot.DARK_PNG, TradeoffPlot.ALL_PNG, TradeoffPlot.ALL_DARK_PNG);

    private static final Table<TradeoffRow> COLUMNS = new Table<TradeoffRow>().value("scene", TradeoffRow::scene)
        .value("rung", TradeoffRow::rung).value("states", TradeoffRow::states).value("impacts", TradeoffRow::impacts)
        .value("jvms", TradeoffRow::jvms).value("rounds", TradeoffRow::rounds)
        .value("nanosPerTurn", row -> row.cost().nanosPerTurn()).value("nanosLow", row -> row.cost().low())
        .value("nanosHigh", row -> row.cost().high()).value("nanosPerImpact", row -> row.cost().nanosPerImpact())
        .value("bytesPerTurn", row -> row.cost().bytesPerTurn()).value("costRatio", TradeoffRow::costRatio)
        .value("errorMedian", TradeoffRow::median).value("error99", TradeoffRow::most99)
        .value("errorWorst", TradeoffRow::worst).value("missed", TradeoffRow::missed)
        .value("invented", TradeoffRow::invented).value("energyError", TradeoffRow::energyError)
        .value("freeTurns", TradeoffRow::freeTurns).value("freeBound", TradeoffRow::freeBound)
        .value("integersDiffering", TradeoffRow::differing).value("integersCompared", TradeoffRow::compared)
        .value("onFront", TradeoffRow::onFront).value("ratioLow", TradeoffRow::ratioLow)
        .value("ratioHigh", TradeoffRow::ratioHigh);

    private final Path folder;
    private final String machine;
    private final String date;
    private final MeasuredTable<TradeoffRow> table;

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
        table = new MeasuredTable<>(folder, "tradeoff", facts(machine, date), COLUMNS);
    }

    private static Fields facts(String machine, String date) {
        return Fields.of("type", "tradeoff", "machine", machine, "date", date);
    }

    /** @throws java.io.UncheckedIOException if it cannot be written */
    public void add(List<TradeoffRow> more) {
        table.add(more);
    }

    /** Writes the plot, see {@link MeasuredTable#finish}. */
    public String finish() {
        TradeoffResult result = new TradeoffResult(machine, date, table.rows());
        return table.finish(() -> TradeoffPlot.write(result, folder));
    }

    /** The result's object. */
    public static Fields fields(TradeoffResult result) {
        return MeasuredTable.fields(facts(result.machine(), result.date()), COLUMNS, result.rows());
    }

    @Override
    public void close() {
        table.close();
    }
}
