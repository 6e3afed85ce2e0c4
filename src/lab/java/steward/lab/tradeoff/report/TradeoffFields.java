package steward.lab.tradeoff.report;

import java.util.List;
import java.util.function.Function;
import steward.lab.tradeoff.TradeoffRow;
import steward.text.CsvRow;

/** The columns of the files, in their order: the same names in CSV and JSON. */
final class TradeoffFields {

    /**
     * A column.
     *
     * @param value a text, a boolean, an integer or a double of a row
     */
    record Field(String name, Function<TradeoffRow, Object> value) { }

    /** All columns; a number that is not finite is empty in CSV and null in JSON. */
    static final List<Field> ALL = List.of(
        new Field("scene", TradeoffRow::scene),
        new Field("rung", TradeoffRow::rung),
        new Field("states", TradeoffRow::states),
        new Field("impacts", TradeoffRow::impacts),
        new Field("jvms", TradeoffRow::jvms),
        new Field("rounds", TradeoffRow::rounds),
        new Field("nanosPerTurn", row -> row.cost().nanosPerTurn()),
        new Field("nanosLow", row -> row.cost().low()),
        new Field("nanosHigh", row -> row.cost().high()),
        new Field("nanosPerImpact", row -> row.cost().nanosPerImpact()),
        new Field("bytesPerTurn", row -> row.cost().bytesPerTurn()),
        new Field("costRatio", TradeoffRow::costRatio),
        new Field("errorMedian", TradeoffRow::median),
        new Field("error99", TradeoffRow::most99),
        new Field("errorWorst", TradeoffRow::worst),
        new Field("missed", TradeoffRow::missed),
        new Field("invented", TradeoffRow::invented),
        new Field("energyError", TradeoffRow::energyError),
        new Field("freeTurns", TradeoffRow::freeTurns),
        new Field("freeBound", TradeoffRow::freeBound),
        new Field("integersDiffering", TradeoffRow::differing),
        new Field("integersCompared", TradeoffRow::compared),
        new Field("onFront", TradeoffRow::onFront),
        new Field("ratioLow", TradeoffRow::ratioLow),
        new Field("ratioHigh", TradeoffRow::ratioHigh));

    static String[] names() {
        return ALL.stream().map(Field::name).toArray(String[]::new);
    }

    /** A row for spreadsheets; names of scenes and rungs may have anything in them. */
    static CsvRow csv(TradeoffRow row) {
        CsvRow cells = new CsvRow();
        for (Field field : ALL) {
            Object value = field.value().apply(row);
            if (value instanceof String text) {
                cells.text(text);
            } else {
                cells.words(value instanceof Double number && !Double.isFinite(number) ? "" : value.toString());
            }
        }
        return cells;
    }
}
