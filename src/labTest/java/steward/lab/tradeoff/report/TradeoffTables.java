package steward.lab.tradeoff.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import steward.lab.tradeoff.TradeoffRow;

/** Reads back the table for spreadsheets. */
final class TradeoffTables {

    private TradeoffTables() {
    }

    static List<TradeoffRow> rows(String csv) {
        List<String> lines = csv.lines().toList();
        String[] names = lines.get(0).split(",");
        List<TradeoffRow> rows = new ArrayList<>();
        for (String line : lines.subList(1, lines.size())) {
            String[] cells = line.split(",", -1);
            Map<String, String> row = new HashMap<>();
            for (int k = 0; k < names.length; k++) {
                row.put(names[k], cells[k].replace("\"", ""));
            }
            rows.add(row(row));
        }
        return rows;
    }

    private static TradeoffRow row(Map<String, String> row) {
        return new TradeoffRow(row.get("scene"), row.get("rung"), whole(row, "states"), whole(row, "impacts"),
            whole(row, "jvms"), whole(row, "rounds"),
            new TradeoffRow.Cost(number(row, "nanosPerTurn"), number(row, "nanosLow"), number(row, "nanosHigh"),
                number(row, "nanosPerImpact"), number(row, "bytesPerTurn")), number(row, "costRatio"),
            number(row, "ratioLow"), number(row, "ratioHigh"), number(row, "errorMedian"), number(row, "error99"),
            number(row, "errorWorst"), whole(row, "missed"),
            whole(row, "invented"), number(row, "energyError"), whole(row, "freeTurns"), whole(row, "freeBound"),
            whole(row, "integersDiffering"), whole(row, "integersCompared"), Boolean.parseBoolean(row.get("onFront")));
    }

    private static int whole(Map<String, String> row, String name) {
        return Integer.parseInt(row.get(name));
    }

    private static double number(Map<String, String> row, String name) {
        return row.get(name).isEmpty() ? Double.NaN : Double.parseDouble(row.get(name));
    }
}
