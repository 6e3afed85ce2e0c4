package steward.lab.tradeoff;

import java.util.List;

/**
 * The results of a run.
 *
 * @param machine  the machine of the run
 * @param date     when, as year-month-day
 * @param rows     scene by scene, each in the order of the ladder
 * @param headings random, then along the axes; empty if they were not measured
 */
public record TradeoffResult(String machine, String date, List<TradeoffRow> rows, List<TradeoffHeadings> headings) {

    /** Copies the lists. */
    public TradeoffResult {
        rows = List.copyOf(rows);
        headings = List.copyOf(headings);
    }

    /** The names of the scenes, in their order. */
    public List<String> scenes() {
        return rows.stream().map(TradeoffRow::scene).distinct().toList();
    }

    /** The rows of a scene, in the order of the ladder. */
    public List<TradeoffRow> of(String scene) {
        return rows.stream().filter(row -> row.scene().equals(scene)).toList();
    }

    /** The row of a rung on a scene, or {@code null}. */
    public TradeoffRow row(String scene, String rung) {
        return rows.stream().filter(row -> row.scene().equals(scene) && row.rung().equals(rung)).findFirst()
            .orElse(null);
    }
}
