package steward.lab.tradeoff;

import java.util.Comparator;
import java.util.List;
import steward.scene.AccuracyFigures;

/**
 * Results of a run of the trade-off: the rows of all scenes and rungs.
 *
 * @param machine the machine of the run
 * @param date    when, as year-month-day
 * @param rows    scene by scene, each in the order of the ladder
 */
public record TradeoffResult(String machine, String date, List<TradeoffRow> rows) {

    public TradeoffResult {
        rows = List.copyOf(rows);
    }

    /** The names of the scenes, in their order. */
    public List<String> scenes() {
        return rows.stream().map(TradeoffRow::scene).distinct().toList();
    }

    /** The rows of a scene, in the order of the ladder. */
    public List<TradeoffRow> of(String scene) {
        return rows.stream().filter(row -> row.scene().equals(scene)).toList();
    }

    /**
     * The rung that suits a scene: the usual one, unless another costs less in every JVM, by more than
     * {@link AccuracyFigures#SAME_COST}. It has to decide as in truth,
     * without a missed or an invented impact, and 99% of its turns are off by at most {@link TradeoffRow#DEMAND}. If
     * the usual rung does not, it is the cheapest that does; of those that cost the same within
     * {@link AccuracyFigures#SAME_COST}, the most accurate. {@code null} if there is none.
     */
    public TradeoffRow chosen(String scene) {
        TradeoffRow usual = row(scene, TradeoffRow.DEFAULT_RUNG);
        boolean suits = usual != null && isRight(usual);
        List<TradeoffRow> meeting = of(scene).stream().filter(TradeoffResult::isRight)
            .filter(row -> !suits || row.ratioHigh() * (1 + AccuracyFigures.SAME_COST) < 1).toList();
        double least = meeting.stream().mapToDouble(TradeoffRow::costRatio).min().orElse(Double.NaN);
        return meeting.stream().filter(row -> row.costRatio() <= least * (1 + AccuracyFigures.SAME_COST))
            .min(Comparator.comparingDouble(TradeoffRow::most99)).orElse(suits ? usual : null);
    }

    private static boolean isRight(TradeoffRow row) {
        return row.most99() <= TradeoffRow.DEMAND && row.missed() + row.invented() == 0;
    }

    /** The row of a rung on a scene, or {@code null}. */
    public TradeoffRow row(String scene, String rung) {
        return rows.stream().filter(row -> row.scene().equals(scene) && row.rung().equals(rung)).findFirst()
            .orElse(null);
    }
}
