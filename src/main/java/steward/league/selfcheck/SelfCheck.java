package steward.league.selfcheck;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.league.pairing.StopRule;
import steward.league.sequential.Gsprt;
import steward.numerics.SplitMix64;

/** The tables of docs/rating.md. */
public final class SelfCheck {

    /** The parts, in the order in which they are printed. */
    public static final List<String> PARTS = List.of("fixed", "exact", "anytime", "rules", "sprt", "adaptive");

    /** Leagues of a configuration, if nothing else is said. */
    public static final long USUAL = 20_000;

    private static final long SEED = 21;
    /** Whole leagues of 16 bots take long: so many times fewer of them. */
    private static final int FEWER = 200;
    private static final int LEAST_WHOLE = 20;
    private static final double EVEN = 0.05;
    /** Elo by which bots are far apart. */
    private static final double FAR = 300;
    /** The last strength with a score of 95% is 5 Elo below. */
    private static final double FARTHEST = 515;
    private static final int MOST_DECISIONS = 5_000_000;

    private final long leagues;
    private final int threads;
    private final Consumer<String> out;

    /**
     * @param leagues of each configuration
     * @param out     takes the lines, as soon as they are known
     */
    public SelfCheck(long leagues, int threads, Consumer<String> out) {
        this.leagues = leagues;
        this.threads = threads;
        this.out = out;
    }

    /** Prints one of {@link #PARTS}. */
    public void print(String part) throws InterruptedException {
        switch (part) {
            case "fixed" -> fixed();
            case "exact" -> exact();
            case "anytime" -> anytime();
            case "rules" -> rules();
            case "sprt" -> sprt();
            default -> adaptive();
        }
        out.accept("");
    }

    private void head(String title, String... columns) {
        out.accept(title);
        out.accept("");
        out.accept("| " + String.join(" | ", columns) + " |");
        out.accept("|" + "---|".repeat(columns.length));
    }

    private void row(Object... cells) {
        StringBuilder line = new StringBuilder("|");
        for (Object cell : cells) {
            line.append(' ').append(cell).append(" |");
        }
        out.accept(line.toString());
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    // ---- configurations --------------------------------------------------------------------------

    private static MadeUpLeague two(double elo) {
        return MadeUpLeague.pairs("2 bots, " + Math.round(elo) + " Elo apart", new double[] {elo, 0}, 0, 0, 0, 0);
    }

    private static List<MadeUpLeague> small() {
        return List.of(two(0), two(100), two(300), two(400), two(480), two(700),
            MadeUpLeague.pairs("2 bots, ties", new double[] {60, 0}, 0.8, 0, 0, 0),
            MadeUpLeague.pairs("2 bots, ties, seeds of 150 Elo", new double[] {60, 0}, 0.5, 50, 150, 0),
            MadeUpLeague.pairs("2 bots, ties, sides of 300 Elo", new double[] {60, 0}, 0.5, 300, 0, 0),
            trio(), mixed(), MadeUpLeague.threes("5 bots, 3 players, seeds of 60 Elo", 60, MadeUpLeague.spaced(5, 60)),
            MadeUpLeague.alone("4 bots, each alone", MadeUpLeague.spaced(4, 60)));
    }

    private static MadeUpLeague trio() {
        return MadeUpLeague.pairs("3 bots, rock, paper, scissors of 150 Elo", MadeUpLeague.spaced(3, 0), 0.1, 0, 0,
            150);
    }

    private static MadeUpLeague mixed() {
        return MadeUpLeague.pairs("6 bots, three of them in a circle, ties, seeds, sides", MadeUpLeague.spaced(6, 40),
            0.3, 30, 60, 100);
    }

    private static MadeUpLeague large() {
        return MadeUpLeague.pairs("30 bots, ties, seeds of 60 Elo", MadeUpLeague.spaced(30, 20), 0.1, 0, 60, 0);
    }

    // ---- the tables ------------------------------------------------------------------------------

    private void fixed() throws InterruptedException {
        head("Bars at a fixed number of clusters: how often they held, and ranges of ranks, in percent.", "league",
            "clusters of a pairing", "scores 5..95%: least", "most", "other scores: least", "ranks: least");
        for (int clusters : new int[] {5, 10, 30, 100, 300}) {
            for (MadeUpLeague league : small()) {
                fixed(Integer.toString(clusters), FixedCheck.even(league, clusters));
            }
        }
        for (MadeUpLeague league : List.of(trio(), mixed(), MadeUpLeague.threes("5 bots, 3 players",  0,
            MadeUpLeague.spaced(5, 60)))) {
            fixed("30 to 400, unequal", new FixedCheck(league, unequal(league.groups().size())));
        }
        for (int clusters : new int[] {5, 30}) {
            fixed(Integer.toString(clusters), FixedCheck.even(large(), clusters));
        }
    }

    private void fixed(String size, FixedCheck check) throws InterruptedException {
        FixedCheck.Outcome found = check.run(threads, leagues, SEED);
        row(check.league().name(), size, Coverage.percent(found.bars().least()),
            Coverage.percent(found.bars().most()), Coverage.percent(found.bars().outer()),
            Coverage.percent(found.ranks()));
    }

    private void exact() {
        head("Bars of 2 bots without ties, computed for all strengths in steps of 5 Elo: how often they hold, in "
            + "percent.", "clusters", "0 to 300 Elo apart: least", "mean", "most", "300 to 510 Elo apart: least",
            "mean", "most");
        for (int clusters : new int[] {30, 40, 60, 100, 200, 300}) {
            ExactCheck check = new ExactCheck(clusters);
            ExactCheck.Outcome near = check.run(0, FAR);
            ExactCheck.Outcome far = check.run(FAR, FARTHEST);
            row(clusters, Coverage.percent(near.least()), Coverage.percent(near.mean()),
                Coverage.percent(near.most()), Coverage.percent(far.least()), Coverage.percent(far.mean()),
                Coverage.percent(far.most()));
        }
    }

    private static int[] unequal(int groups) {
        SplitMix64 random = new SplitMix64(SEED);
        int[] clusters = new int[groups];
        for (int k = 0; k < groups; k++) {
            clusters[k] = 30 + random.nextInt(371);
        }
        return clusters;
    }

    private void coverage(MadeUpLeague league, String size, Coverage found) {
        row(league.name(), size, Coverage.percent(found.least()), Coverage.percent(found.most()),
            Coverage.percent(found.outer()));
    }

    private void anytime() throws InterruptedException {
        head("Anytime bars: how often they held at all looks, in percent.", "league", "clusters of a pairing",
            "scores 5..95%: least", "most", "other scores: least");
        for (MadeUpLeague league : small()) {
            int rounds = league.bots() == 2 ? 3000 : league.bots() < 5 ? 1000 : 300;
            coverage(league, "1 to " + rounds, new AnytimeCheck(league, rounds).run(threads, leagues, SEED));
        }
        coverage(large(), "1 to 16", new AnytimeCheck(large(), 16).run(threads, leagues, SEED));
    }

    private void rules() throws InterruptedException {
        head("Leagues that are ended by a rule: how often anytime bars held at all looks and at the end, and all that "
            + "was said of the order was true, in percent.", "league", "pairing", "rule", "seeds, mean",
            "bars at all looks: least", "bars at the end: least", "order true");
        StopRule bars = new StopRule(50, false, StopRule.USUAL_EQUAL);
        StopRule ranked = new StopRule(Double.NaN, true, 30);
        for (MadeUpLeague league : List.of(trio(), mixed(),
            MadeUpLeague.threes("5 bots, 3 players", 0, MadeUpLeague.spaced(5, 60)))) {
            for (boolean adaptive : new boolean[] {false, true}) {
                for (StopRule rule : List.of(bars, ranked)) {
                    AdaptiveCheck.Outcome found = new AdaptiveCheck(league, adaptive, rule, MOST_DECISIONS)
                        .run(threads, leagues, SEED);
                    row(league.name(), adaptive ? "adaptive" : "round robin",
                        rule.ranked() ? "--until-ranked --equal 30" : "--until-bars 50",
                        Math.round(found.decisions()), Coverage.percent(found.coverage().least()),
                        Coverage.percent(found.atEnd().least()),
                        rule.ranked() ? Coverage.percent(found.right()) : "-");
                }
            }
        }
    }

    private void sprt() throws InterruptedException {
        head("Sequential tests with alpha = beta = 0.05: how often H1 was accepted, and seeds until the end.", "Elo",
            "games", "truth", "H1 accepted", "seeds, mean", "theory", "of theory");
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double[] elo : new double[][] {{0, 20}, {0, 10}, {-10, 0}, {0, 5}}) {
                for (double ties : new double[] {0, 1}) {
                    for (double at : new double[] {elo[0], elo[1]}) {
                        SprtCheck.Outcome found = new SprtCheck(new Gsprt(elo[0], elo[1], EVEN, EVEN, model), at,
                            ties, 100 * ties).run(threads, leagues, SEED);
                        row(model.name().toLowerCase(Locale.ROOT) + " " + Math.round(elo[0]) + " to "
                            + Math.round(elo[1]), ties > 0 ? "ties, seeds of 100 Elo" : "no ties", Math.round(at),
                            number("%.4f", found.accepted()), Math.round(found.mean()),
                            Math.round(found.theory().observations()),
                            number("%.3f", found.mean() / found.theory().observations()));
                    }
                }
            }
        }
    }

    private void adaptive() throws InterruptedException {
        long whole = Math.max(LEAST_WHOLE, leagues / FEWER);
        head("16 bots until --until-ranked --equal 5, " + whole + " leagues.", "steps between neighbours, Elo",
            "round robin, seeds", "adaptive, seeds", "share", "order true");
        double[][] steps = {{10, 60, 20, 50, 30, 40, 15, 55, 25, 45, 35, 60, 20, 50, 30},
            {60, 57, 53, 50, 46, 43, 39, 36, 32, 29, 25, 22, 18, 14, 10},
            {35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35}};
        for (double[] each : steps) {
            double[] elo = new double[each.length + 1];
            List<String> words = new ArrayList<>();
            for (int k = 0; k < each.length; k++) {
                elo[k + 1] = elo[k] - each[k];
                words.add(Long.toString(Math.round(each[k])));
            }
            MadeUpLeague league = MadeUpLeague.pairs("16 bots", elo, 0.3, 20, 50, 0);
            StopRule rule = new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL);
            AdaptiveCheck.Outcome turns = new AdaptiveCheck(league, false, rule, MOST_DECISIONS)
                .run(threads, whole, SEED);
            AdaptiveCheck.Outcome learnt = new AdaptiveCheck(league, true, rule, MOST_DECISIONS)
                .run(threads, whole, SEED);
            row(String.join(" ", words), Math.round(turns.decisions()), Math.round(learnt.decisions()),
                number("%.2f", learnt.decisions() / turns.decisions()), Coverage.percent(learnt.right()));
        }
    }
}
