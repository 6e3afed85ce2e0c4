package steward.lab.tradeoff.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import steward.lab.tradeoff.TradeoffResult;
import steward.lab.tradeoff.TradeoffRow;

/** Table and sentences on how to choose. A sentence stands only where the figures bear it out. */
record TradeoffAdvice(TradeoffResult result) {

    /** The scenes that the sentences are about. */
    static final String RACE = "official-race";
    static final String GRAZING = "grazing";

    private static final String OFFICIAL = "event/official";
    private static final String STEP = "step/";
    private static final String FEWEST_STEPS = "step/1";
    private static final String DOUBLE = TradeoffRow.DEFAULT_RUNG;
    private static final String COMPENSATED = "event/compensated";
    private static final String EXACT = "event/exact";

    /** Kinds of scenes, by the scene that stands for each. */
    private static final Map<String, String> KINDS = Map.of(RACE, "race", "brawl", "brawl", "walled-race",
        "race among walls", "dense-box", "box, crowded", "gas", "crowd", "bullets", "bullets", "avalanche", "pile",
        "bowl", "bowl", GRAZING, "graze");
    /** A share of impacts. */
    private static final double RARELY = 0.001;
    /** Of rungs that cost less than this, in turns of {@code double}, the range over JVMs is of no interest. */
    private static final double LEAST_COST = 0.1;

    /** The table: a line per kind of scene. */
    String table() {
        StringBuilder out = new StringBuilder("| kind of scene | rung | wrong impacts | error | times `double` "
            + "| a turn | on your own scene |\n|---|---|---:|---:|---:|---:|---|\n");
        for (String scene : result.scenes()) {
            TradeoffRow row = result.chosen(scene);
            String kind = KINDS.getOrDefault(scene, scene);
            out.append(String.format(Locale.ROOT, "| [%s](#%s) | ", kind, anchor(scene)));
            out.append(row == null ? "none | | | | | " : String.format(Locale.ROOT,
                "`%s` | %d of %,d | %s u | %s | %s | ", row.shortName(), row.missed() + row.invented(), row.impacts(),
                TradeoffPage.power(row.most99()), range(row), TradeoffPlot.time(row.cost().nanosPerTurn())));
            out.append("`steward tradeoff --quick --scene ").append(KINDS.containsKey(scene) ? scene + " --scene " : "")
                .append("my-scene.json` |\n");
        }
        return out.toString();
    }

    /** The name of a heading, as code hosts make it. */
    static String anchor(String scene) {
        return scene.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N} _-]", "").replace(' ', '-');
    }

    /** The range of a ratio over JVMs; one number if it is none with two digits. */
    static String range(TradeoffRow row) {
        String low = String.format(Locale.ROOT, "%.2f", row.ratioLow());
        String high = String.format(Locale.ROOT, "%.2f", row.ratioHigh());
        return low.equals(high) ? low : low + " - " + high;
    }

    List<String> sentences() {
        List<String> all = new ArrayList<>();
        usual(all);
        TradeoffRow official = result.row(RACE, OFFICIAL);
        if (official != null) {
            all.add(String.format(Locale.ROOT, "**The server's results** need `official`, the published referee's "
                + "own expressions. On a race turn it costs %s times as much as `double`. %s.", range(official),
                ends(official)));
        }
        grazing(all);
        search(all);
        manySteps(all);
        states(all);
        return all;
    }

    private static String ends(TradeoffRow row) {
        return row.differing() == 0
            ? String.format(Locale.ROOT, "None of %,d pod-turns ends in rounded values that differ from the exact ones",
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
        if (graze != null && wrong - graze.missed() - graze.invented() <= RARELY * (impacts - graze.impacts())) {
            all.add(String.format(Locale.ROOT, "**The default** is `double`: over all scenes it missed or "
                + "invented %,d of %,d impacts, %,d of them among grazing passes. 99%% of its turns were off by "
                + "at most %s u (%s).", wrong, impacts, graze.missed() + graze.invented(),
                TradeoffPage.power(worst.most99()), worst.scene()));
        }
    }

    /** Holds if the most careful rung decides better than the others. */
    private void grazing(List<String> all) {
        TradeoffRow exact = result.row(GRAZING, EXACT);
        if (exact == null || wrong(EXACT) > wrong(COMPENSATED) || wrong(COMPENSATED) >= wrong(DOUBLE)) {
            return;
        }
        TradeoffRow most = result.rows().stream().filter(row -> row.rung().equals(EXACT))
            .max(Comparator.comparingDouble(TradeoffRow::ratioHigh)).orElseThrow();
        all.add(String.format(Locale.ROOT, "**If a graze decides**, take `compensated` or `exact`. Of %,d passes at "
            + "a hair's breadth `exact` got %d wrong, `compensated` %d and `double` %d. `exact` decides by signs that "
            + "are proven, and costs up to %.2f times as much as `double` (%s).", exact.states(), wrong(EXACT),
            wrong(COMPENSATED), wrong(DOUBLE), most.ratioHigh(), most.scene()));
    }

    private long wrong(String rung) {
        TradeoffRow row = result.row(GRAZING, rung);
        return row.missed() + row.invented();
    }

    /** Holds if a step costs less than the cheapest exact time. */
    private void search(List<String> all) {
        TradeoffRow step = result.row(RACE, FEWEST_STEPS);
        if (step == null || step.ratioHigh() >= cheapestEvent(RACE).costRatio()) {
            return;
        }
        List<String> pays = new ArrayList<>();
        for (String scene : result.scenes()) {
            TradeoffRow event = cheapestEvent(scene);
            String last = null;
            for (TradeoffRow row : result.of(scene)) {
                last = isStep(row) && row.costRatio() < event.costRatio() ? row.rung() : last;
            }
            pays.add(last == null ? "none on " + scene : "`" + last + "` on " + scene);
        }
        all.add(String.format(Locale.ROOT, "**A search** that can do with less may take `%s`. On a race turn it costs "
            + "%s times as much as `double`, misses %.0f%% of the impacts, and is off by more than %s u in 1%% of the "
            + "turns. The most steps that cost less than any rung with exact times: %s.", FEWEST_STEPS, range(step),
            100.0 * step.missed() / Math.max(1, step.impacts()), TradeoffPage.plain(step.most99()),
            String.join(", ", pays)));
    }

    private static boolean isStep(TradeoffRow row) {
        return row.rung().startsWith(STEP);
    }

    private static int steps(TradeoffRow row) {
        return Integer.parseInt(row.rung().substring(STEP.length()));
    }

    /** Holds from the least number of steps on that is on no front. */
    private void manySteps(List<String> all) {
        int most = result.rows().stream().filter(row -> isStep(row) && row.onFront())
            .mapToInt(TradeoffAdvice::steps).max().orElse(0);
        int next = result.rows().stream().filter(TradeoffAdvice::isStep).mapToInt(TradeoffAdvice::steps)
            .filter(steps -> steps > most).min().orElse(0);
        if (next > 0) {
            all.add(String.format(Locale.ROOT, "**`step/%d` and more** are never on the front: on every scene some "
                + "rung is both cheaper and nearer to the truth. Use them to compare with a program that takes as "
                + "many steps, or to see steps converge: the error falls only as their number grows.", next));
        }
    }

    /** Holds if a ratio has a range; of rungs that cost next to nothing it says nothing. */
    private void states(List<String> all) {
        TradeoffRow widest = result.rows().stream().filter(row -> row.jvms() > 1 && row.costRatio() >= LEAST_COST)
            .max(Comparator.comparingDouble(row -> row.ratioHigh() / row.ratioLow())).orElse(null);
        if (widest != null && widest.ratioHigh() > widest.ratioLow()) {
            all.add(String.format(Locale.ROOT, "**A price is a range**: the compiler settles in one of several states, "
                + "and a rung that does more may for once cost less. Over %d JVMs, `%s` on %s has the widest range of "
                + "the rungs that cost at least a tenth of `double`: from %.2f to %.2f times `double`. Measure "
                + "on your machine before you count on less.",
                widest.jvms(), widest.shortName(), widest.scene(), widest.ratioLow(), widest.ratioHigh()));
        }
    }

    private TradeoffRow cheapestEvent(String scene) {
        return result.of(scene).stream().filter(row -> !isStep(row))
            .min(Comparator.comparingDouble(TradeoffRow::costRatio)).orElseThrow();
    }
}
