package steward.lab.tradeoff.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.lab.chart.MeasuredTable;
import steward.lab.chart.MeasuredTable.Column;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;
import tools.jackson.core.JsonGenerator;

/** Report of the measured trade-off in files, the rows of a scene together. The pictures come last. */
public final class TradeoffReport implements AutoCloseable {

    /** Name of the table for spreadsheets. */
    public static final String CSV = "tradeoff.csv";
    /** Name of the table for programs. */
    public static final String JSON = "tradeoff.json";
    /** All files that a run writes. */
    public static final List<String> ALL = List.of(CSV, JSON,
        TradeoffPlot.PNG, TradeoffPlot.DARK_PNG, TradeoffPlot.ALL_PNG, TradeoffPlot.ALL_DARK_PNG);

    private static final List<Column<TradeoffRow>> COLUMNS = List.of(
        new Column<>("scene", TradeoffRow::scene),
        new Column<>("rung", TradeoffRow::rung),
        new Column<>("states", TradeoffRow::states),
        new Column<>("impacts", TradeoffRow::impacts),
        new Column<>("jvms", TradeoffRow::jvms),
        new Column<>("rounds", TradeoffRow::rounds),
        new Column<>("nanosPerTurn", row -> row.cost().nanosPerTurn()),
        new Column<>("nanosLow", row -> row.cost().low()),
        new Column<>("nanosHigh", row -> row.cost().high()),
        new Column<>("nanosPerImpact", row -> row.cost().nanosPerImpact()),
        new Column<>("bytesPerTurn", row -> row.cost().bytesPerTurn()),
        new Column<>("costRatio", TradeoffRow::costRatio),
        new Column<>("errorMedian", TradeoffRow::median),
        new Column<>("error99", TradeoffRow::most99),
        new Column<>("errorWorst", TradeoffRow::worst),
        new Column<>("missed", TradeoffRow::missed),
        new Column<>("invented", TradeoffRow::invented),
        new Column<>("energyError", TradeoffRow::energyError),
        new Column<>("freeTurns", TradeoffRow::freeTurns),
        new Column<>("freeBound", TradeoffRow::freeBound),
        new Column<>("integersDiffering", TradeoffRow::differing),
        new Column<>("integersCompared", TradeoffRow::compared),
        new Column<>("onFront", TradeoffRow::onFront),
        new Column<>("ratioLow", TradeoffRow::ratioLow),
        new Column<>("ratioHigh", TradeoffRow::ratioHigh));

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
        table = new MeasuredTable<>(folder, facts(machine, date), COLUMNS);
    }

    private static Map<String, String> facts(String machine, String date) {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("type", "tradeoff");
        facts.put("machine", machine);
        facts.put("date", date);
        return facts;
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

    /** Writes the fields of the result's object. */
    public static void write(JsonGenerator out, TradeoffResult result) {
        MeasuredTable.write(out, facts(result.machine(), result.date()), COLUMNS, result.rows());
    }

    @Override
    public void close() {
        table.close();
    }
}
