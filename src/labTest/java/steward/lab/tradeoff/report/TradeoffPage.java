package steward.lab.tradeoff.report;

import java.util.List;
import java.util.Locale;
import steward.lab.chart.PictureTag;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;
import steward.scene.AccuracyFigures;
import steward.text.TextFormat;

/** The page: what to choose on its first screen, then the picture and the tables. All numbers are measured. */
public final class TradeoffPage {

    private static final String ABOVE = """
        A *rung* is a setting of [accuracy](accuracy.md). A rung is named here if it decides every impact as in truth
        and 99%% of its turns are off by at most %s u. It is `double`, the default, unless that fails or another rung
        costs less in every JVM, by more than %.0f%%. Wrong impacts are missed or invented. The error is that of 99%% of
        the turns. If heaps of more than 12 come to rest, `exact` stands for the truth. The last column measures your
        scene beside this one.
        """;
    private static final String MEANING = """
        ## What was measured

        Cost is CPU time of one thread. Each rung was timed in %s of its own, one after the other, in rounds that
        go from rung to rung. A JVM's time is the median of its rounds. Over JVMs there is no median, since compilers
        settle in different states: "a turn" is the JVM in the middle, with the fastest and the slowest beside it. A
        ratio is that of the middle ones; its range is that of two JVMs measured in the same rounds. Compare ratios
        rather than nanoseconds.

        Errors are against the oracle, the same turn in 64 decimal digits, from the same states that were timed: the
        farthest that any body's centre is off. Two kinds of turns are compared with `exact` instead: a body
        [slides](scenes.md#rest-and-sliding) along a rim, or a heap of more than 12 comes to rest. An impact is missed
        or invented if other pairs meet. "Free run": after how many turns without commands and forces a body is off by
        1 u, the median of some runs. "Ends": how many bodies end their turn in rounded values that differ from the
        exact ones. A rung with a star is on the Pareto front: no other is both cheaper and nearer to the truth. All
        figures are in [%s](%s).
        """;
    private static final String ONE_JVM = "Measured with --quick: few states, one JVM a rung. These figures may not be "
        + "quoted.";
    private static final int FEWEST_JVMS = 2;

    private final TradeoffResult result;

    private TradeoffPage(TradeoffResult result) {
        this.result = result;
    }

    /** In Markdown; sentences that do not hold, or whose measurements are missing, are left out. */
    public static String text(TradeoffResult result) {
        TradeoffPage page = new TradeoffPage(result);
        TradeoffAdvice advice = new TradeoffAdvice(result);
        int jvms = result.rows().stream().mapToInt(TradeoffRow::jvms).min().orElse(0);
        StringBuilder out = new StringBuilder("# Speed against accuracy\n\n").append(advice.table()).append('\n')
            .append(String.format(Locale.ROOT, ABOVE, TradeoffRow.DEMAND, 100 * AccuracyFigures.SAME_COST))
            .append("\nWritten by `steward tradeoff` on ").append(result.date()).append(": ").append(result.machine())
            .append(".\n")
            .append(jvms < FEWEST_JVMS ? "\n" + ONE_JVM + "\n" : "");
        int number = 1;
        for (String sentence : advice.sentences()) {
            out.append(number == 1 ? "\n## How to choose\n\n" : "").append(number++).append(". ").append(sentence)
                .append('\n');
        }
        out.append("\n## Picture\n\n").append(PictureTag.of(TradeoffPlot.ALL_PNG, TradeoffPlot.ALL_DARK_PNG,
            "Error against cost, a panel a scene")).append("\n\n").append(String.format(Locale.ROOT, MEANING,
            TextFormat.count(jvms, "JVM"), TradeoffReport.CSV, TradeoffReport.CSV));
        for (String scene : result.scenes()) {
            page.table(scene, out);
        }
        return out.toString();
    }

    private void table(String scene, StringBuilder out) {
        List<TradeoffRow> rows = result.of(scene);
        TradeoffRow first = rows.get(0);
        boolean rounds = first.compared() > 0;
        out.append(String.format(Locale.ROOT, "%n### %s%n%n%,d states with %,d impacts; %d rounds in %s. "
            + "Its panel is in the [picture](#picture).%n%n",
            scene, first.states(), first.impacts(), first.rounds(), TextFormat.count(first.jvms(), "JVM")));
        out.append("| rung | a turn | over JVMs | an impact | bytes | ratio | over JVMs | error, median "
            + "| 99% | worst | missed | invented | energy | free run |").append(rounds ? " ends |\n" : "\n");
        out.append("|---|").append("---:|".repeat(rounds ? 14 : 13)).append('\n');
        for (TradeoffRow row : rows) {
            out.append(String.join(" | ", "| " + row.rung() + (row.onFront() ? " *" : ""),
                TradeoffPlot.time(row.cost().nanosPerTurn()),
                TradeoffPlot.time(row.cost().low()) + " - " + TradeoffPlot.time(row.cost().high()),
                TradeoffPlot.time(row.cost().nanosPerImpact()),
                number("%.0f", row.cost().bytesPerTurn()), number("%.2f", row.costRatio()),
                TradeoffAdvice.range(row), power(row.median()),
                power(row.most99()), power(row.worst()), Long.toString(row.missed()), Long.toString(row.invented()),
                power(row.energyError()), (row.freeTurns() > row.freeBound() ? "> " + row.freeBound()
                    : Integer.toString(row.freeTurns())) + " |"));
            out.append(rounds ? String.format(Locale.ROOT, " %,d of %,d |%n", row.differing(), row.compared()) : "\n");
        }
    }

    private static String number(String format, double value) {
        return Double.isNaN(value) ? "-" : String.format(Locale.ROOT, format, value);
    }

    static String plain(double value) {
        return value >= 1 ? String.format(Locale.ROOT, "%.0f", value) : power(value);
    }

    static String power(double value) {
        return value == 0 ? "0" : Double.isInfinite(value) ? "infinite" : String.format(Locale.ROOT, "%.1e", value);
    }
}
