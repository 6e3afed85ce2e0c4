package steward.lab.tradeoff.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import steward.lab.tradeoff.TradeoffHeadings;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;
import steward.text.TextFormat;

/**
 * The page with the picture, sentences on how to choose, and the tables. All numbers are measured, and a sentence
 * stands only where they bear it out.
 */
public final class TradeoffPage {

    /** The scenes that the sentences are about. */
    static final String RACE = "official-race";
    static final String GRAZING = "grazing";

    private static final String OFFICIAL = "event/official";
    private static final String STEP = "step/1";
    private static final String DOUBLE = TradeoffRow.DEFAULT_RUNG;
    private static final String COMPENSATED = "event/compensated";
    private static final String EXACT = "event/exact";

    private static final String MEANING = """
        ## What was measured

        Cost is CPU time of one thread. Each rung was timed in %s of its own, one after the other, in rounds that
        go from rung to rung; a turn's time is the median of all its rounds, four in five of which are in the range
        beside it, and a ratio is that of two such times. Compare ratios rather than nanoseconds. Errors are against the
        oracle (64 decimal digits) after one turn from the same states that were timed: the farthest that any body's
        centre is off. An impact is missed or invented if other pairs meet. "Free run": after how many turns without
        commands a body is off by 1 u, the median of some runs. "Ends": how many bodies end their turn in rounded
        values that differ from the exact ones. A rung with a star is on the Pareto front: none is both cheaper and
        nearer to the truth.
        """;
    private static final String PICTURE = "<picture><source media=\"(prefers-color-scheme: dark)\" srcset=\""
        + TradeoffPlot.DARK_PNG + "\"><img alt=\"Position error against cost\" src=\"" + TradeoffPlot.PNG
        + "\"></picture>";
    private static final String ONE_JVM = "Measured with --quick: few states, one JVM a rung. These figures may not be "
        + "quoted.";
    private static final int FEWEST_JVMS = 2;
    /** A share of impacts. */
    private static final double RARELY = 0.001;

    private final TradeoffResult result;

    private TradeoffPage(TradeoffResult result) {
        this.result = result;
    }

    /** In Markdown; sentences that do not hold, or whose measurements are missing, are left out. */
    public static String text(TradeoffResult result) {
        TradeoffPage page = new TradeoffPage(result);
        StringBuilder out = new StringBuilder();
        out.append("# Speed against accuracy\n\nWritten by `steward tradeoff` on ").append(result.date())
            .append(": ").append(result.machine()).append(".\n\n").append(PICTURE).append("\n\n");
        int jvms = result.rows().stream().mapToInt(TradeoffRow::jvms).min().orElse(0);
        out.append(jvms < FEWEST_JVMS ? ONE_JVM + "\n\n" : "");
        int number = 1;
        for (String sentence : page.sentences()) {
            out.append(number == 1 ? "## How to choose\n\n" : "").append(number++).append(". ").append(sentence)
                .append('\n');
        }
        out.append(number == 1 ? "" : "\n").append(String.format(Locale.ROOT, MEANING, TextFormat.count(jvms, "JVM")));
        for (String scene : result.scenes()) {
            page.table(scene, out);
        }
        page.headings(out);
        return out.toString();
    }

    private List<String> sentences() {
        List<String> all = new ArrayList<>();
        TradeoffRow official = result.row(RACE, OFFICIAL);
        if (official != null) {
            all.add(String.format(Locale.ROOT, "**The server's results** need `%s`: the published referee's own "
                + "expressions, for %.2f times the cost of `%s` on a race turn, and %s.", OFFICIAL,
                official.costRatio(), DOUBLE, ends(official)));
        }
        usual(all);
        grazing(all);
        search(all);
        trigonometry(all);
        return all;
    }

    private static String ends(TradeoffRow row) {
        return row.differing() == 0
            ? String.format(Locale.ROOT, "none of %,d pod-turns ends in rounded values that differ from the exact ones",
                row.compared())
            : String.format(Locale.ROOT, "%,d of %,d pod-turns end in rounded values that differ from the exact ones",
                row.differing(), row.compared());
    }

    /** Holds if it hardly ever decides wrongly but where passes graze. */
    private void usual(List<String> all) {
        long wrong = 0;
        long impacts = 0;
        TradeoffRow worst = null;
        for (TradeoffRow row : result.rows()) {
            if (row.rung().equals(DOUBLE)) {
                wrong += row.missed() + row.invented();
                impacts += row.impacts();
                worst = worst == null || row.most99() > worst.most99() ? row : worst;
            }
        }
        TradeoffRow graze = result.row(GRAZING, DOUBLE);
        if (graze != null
            && wrong - graze.missed() - graze.invented() <= RARELY * (impacts - graze.impacts())) {
            all.add(String.format(Locale.ROOT, "**Any other scene** starts with `%s`: over all scenes it missed or "
                + "invented %,d of %,d impacts, %,d of them among grazing passes, and 99%% of its turns were off by "
                + "at most %s u (%s).", DOUBLE, wrong, impacts, graze.missed() + graze.invented(),
                power(worst.most99()), worst.scene()));
        }
    }

    /** Holds if the most careful rung decides better than the others. */
    private void grazing(List<String> all) {
        TradeoffRow exact = result.row(GRAZING, EXACT);
        if (exact == null || wrong(EXACT) >= Math.min(wrong(COMPENSATED), wrong(DOUBLE))) {
            return;
        }
        List<TradeoffRow> costs = result.rows().stream().filter(row -> row.rung().equals(EXACT))
            .sorted(Comparator.comparingDouble(TradeoffRow::costRatio)).toList();
        TradeoffRow least = costs.get(0);
        TradeoffRow most = costs.get(costs.size() - 1);
        all.add(String.format(Locale.ROOT, "**Where a graze decides**, take `%s`: of %,d passes at a hair's breadth it "
            + "got %d wrong, `%s` %d and `%s` %d, and its turns cost from %.2f (%s) to %.2f times (%s) those of "
            + "`%s`.", EXACT, exact.states(), wrong(EXACT), COMPENSATED, wrong(COMPENSATED), DOUBLE, wrong(DOUBLE),
            least.costRatio(), least.scene(), most.costRatio(), most.scene(), DOUBLE));
    }

    private long wrong(String rung) {
        TradeoffRow row = result.row(GRAZING, rung);
        return row.missed() + row.invented();
    }

    /** Holds if a step costs less than the cheapest exact time. */
    private void search(List<String> all) {
        TradeoffRow step = result.row(RACE, STEP);
        if (step == null || step.costRatio() >= cheapestEvent(RACE).costRatio()) {
            return;
        }
        List<String> pays = new ArrayList<>();
        for (String scene : result.scenes()) {
            TradeoffRow event = cheapestEvent(scene);
            String last = null;
            for (TradeoffRow row : result.of(scene)) {
                last = row.rung().startsWith("step/") && row.costRatio() < event.costRatio() ? row.rung() : last;
            }
            pays.add(last == null ? "none on " + scene : "`" + last + "` on " + scene);
        }
        all.add(String.format(Locale.ROOT, "**A search** that can do with less may take `%s`: %.2f times the cost "
            + "of `%s` on a race turn, with %.0f%% of the impacts missed and 1%% of the turns off by more than %s u. "
            + "The most steps that cost less than any rung with exact times: %s.", STEP, step.costRatio(),
            DOUBLE, 100.0 * step.missed() / Math.max(1, step.impacts()), plain(step.most99()),
            String.join(", ", pays)));
    }

    private TradeoffRow cheapestEvent(String scene) {
        return result.of(scene).stream().filter(row -> row.rung().startsWith("event/"))
            .min(Comparator.comparingDouble(TradeoffRow::costRatio)).orElseThrow();
    }

    /** Holds if unit vectors are faster. */
    private void trigonometry(List<String> all) {
        if (result.headings().size() < 2
            || result.headings().get(0).nanosVector() >= result.headings().get(0).nanosAngles()) {
            return;
        }
        TradeoffHeadings random = result.headings().get(0);
        TradeoffHeadings axis = result.headings().get(1);
        all.add(String.format(Locale.ROOT, "**Headings as unit vectors** instead of angles cost %s instead of %s "
            + "a pod's turn, and change the final whole numbers of %,d in %,d pod-turns at random headings "
            + "(a share of %s) but of %.2f%% along the axes: good for a search, not for a referee.",
            time(random.nanosVector()), time(random.nanosAngles()), random.differing(), random.podTurns(),
            power((double) random.differing() / random.podTurns()), 100.0 * axis.differing() / axis.podTurns()));
    }

    private void table(String scene, StringBuilder out) {
        List<TradeoffRow> rows = result.of(scene);
        TradeoffRow first = rows.get(0);
        boolean rounds = first.compared() > 0;
        out.append(String.format(Locale.ROOT, "%n### %s%n%n%,d states with %,d impacts, %d rounds.%n%n", scene,
            first.states(), first.impacts(), first.rounds()));
        out.append("| rung | a turn | four in five rounds | an impact | bytes | ratio | error, median "
            + "| 99% | worst | missed | invented | energy | free run |").append(rounds ? " ends |\n" : "\n");
        out.append("|---|").append("---:|".repeat(rounds ? 13 : 12)).append('\n');
        for (TradeoffRow row : rows) {
            out.append(String.join(" | ", "| " + row.rung() + (row.onFront() ? " *" : ""),
                time(row.cost().nanosPerTurn()), time(row.cost().low()) + " - " + time(row.cost().high()),
                time(row.cost().nanosPerImpact()),
                number("%.0f", row.cost().bytesPerTurn()), number("%.2f", row.costRatio()), power(row.median()),
                power(row.most99()), power(row.worst()), Long.toString(row.missed()), Long.toString(row.invented()),
                power(row.energyError()), (row.freeTurns() > row.freeBound() ? "> " + row.freeBound()
                    : Integer.toString(row.freeTurns())) + " |"));
            out.append(rounds ? String.format(Locale.ROOT, " %,d of %,d |%n", row.differing(), row.compared()) : "\n");
        }
    }

    private void headings(StringBuilder out) {
        if (result.headings().isEmpty()) {
            return;
        }
        out.append("\n### Headings\n\nA free turn of a pod under the official rule, with StrictMath's atan2 and "
            + "correctly rounded cos and sin, and with unit vectors.\n\n"
            + "| headings | pod-turns | other whole numbers | angles | unit vectors |\n"
            + "|---|---:|---:|---:|---:|\n");
        for (TradeoffHeadings each : result.headings()) {
            out.append(String.format(Locale.ROOT, "| %s | %,d | %,d | %s | %s |%n", each.headings(), each.podTurns(),
                each.differing(), time(each.nanosAngles()), time(each.nanosVector())));
        }
    }

    private static String number(String format, double value) {
        return Double.isNaN(value) ? "-" : String.format(Locale.ROOT, format, value);
    }

    /** With three digits or more. */
    static String time(double nanos) {
        return Double.isNaN(nanos) ? "-" : nanos < 100 ? number("%.1f ns", nanos)
            : nanos < 1e4 ? number("%.0f ns", nanos)
            : nanos < 1e5 ? number("%.1f us", nanos / 1e3) : nanos < 1e7 ? number("%.0f us", nanos / 1e3)
            : number("%.1f ms", nanos / 1e6);
    }

    private static String plain(double value) {
        return value >= 1 ? String.format(Locale.ROOT, "%.0f", value) : power(value);
    }

    private static String power(double value) {
        return value == 0 ? "0" : Double.isInfinite(value) ? "infinite" : String.format(Locale.ROOT, "%.1e", value);
    }
}
