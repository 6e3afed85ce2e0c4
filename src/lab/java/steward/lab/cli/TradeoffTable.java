package steward.lab.cli;

import java.util.List;
import java.util.Locale;
import steward.cli.streams.Streams;
import steward.lab.tradeoff.TradeoffRow;
import steward.lab.tradeoff.TradeoffScene;
import steward.text.TextFormat;

/** Printer of the trade-off, scene by scene: a line per rung. */
record TradeoffTable(Streams streams) {

    private static final int RUNG = 19;
    private static final int[] WIDTHS = {8, 8, 5, 8, 8, 8, 8, 7, 7, 8, 6, 6};
    private static final String[][] HEADER = {
        {"turn", "impact", "B per", "cost", "error", "error", "error", "", "in-", "energy", "free", "ends"},
        {"costs", "costs", "turn", "ratio", "median", "99%", "worst", "missed", "vented", "error", "run", "differ"}};

    void add(TradeoffScene scene, List<TradeoffRow> rows) {
        TradeoffRow first = rows.get(0);
        streams.out().println(scene.name() + ": " + scene.about() + ";");
        streams.out().println("  " + TextFormat.count(first.states(), "state") + " with "
            + TextFormat.count(first.impacts(), "impact") + ", " + TextFormat.count(first.rounds(), "round")
            + " of timing in " + TextFormat.count(first.jvms(), "JVM") + " of each rung's own");
        for (String[] header : HEADER) {
            line("", header);
        }
        for (TradeoffRow row : rows) {
            line(row.rung() + (row.onFront() ? " *" : ""), time(row.cost().nanosPerTurn()),
                time(row.cost().nanosPerImpact()), format("%.0f", row.cost().bytesPerTurn()),
                format("%.2f", row.costRatio()), format("%.1e", row.median()), format("%.1e", row.most99()),
                format("%.1e", row.worst()), Long.toString(row.missed()), Long.toString(row.invented()),
                format("%.1e", row.energyError()), row.freeTurns() > row.freeBound() ? ">" + row.freeBound()
                    : Integer.toString(row.freeTurns()),
                row.compared() == 0 ? "-" : Long.toString(row.differing()));
        }
        if (first.compared() > 0) {
            streams.out().println("  ends: of " + TextFormat.count(first.compared(), "body-turn")
                + ", so many end in rounded values that differ from the exact ones");
        }
        streams.out().println();
        streams.out().flush();
    }

    private void line(String rung, String... cells) {
        StringBuilder line = new StringBuilder("  " + TextFormat.left(rung, RUNG));
        for (int k = 0; k < cells.length; k++) {
            line.append(' ').append(TextFormat.right(cells[k], WIDTHS[k]));
        }
        streams.out().println(line.toString().stripTrailing());
    }

    /**
     * Prints the meaning of the columns.
     *
     * @param quick whether the figures are rough
     */
    void end(boolean quick) {
        streams.out().println();
        streams.out().println("* on the Pareto front: no rung is both cheaper and nearer to the truth. Errors in u; "
            + "energy as a share;");
        streams.out().println("free run: turns without commands until a body is off by 1 u. Times are CPU time of one "
            + "thread.");
        if (quick) {
            streams.out().println("--quick: few states, and one JVM a rung. These figures may not be quoted.");
        }
    }

    private static String format(String format, double value) {
        return Double.isNaN(value) ? "-" : Double.isInfinite(value) ? "inf" : String.format(Locale.ROOT, format, value);
    }

    private static String time(double nanos) {
        return nanos < 100 ? format("%.1f ns", nanos) : nanos < 1e4 ? format("%.0f ns", nanos)
            : nanos < 1e7 ? format("%.1f us", nanos / 1e3)
            : Double.isNaN(nanos) ? "-" : format("%.0f ms", nanos / 1e6);
    }
}
