package steward.lab.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.league.pairing.StopRule;
import steward.league.sequential.Gsprt;
import steward.numerics.SplitMix64;

/** The tables of docs/tables/rating.md. */
public final class SelfCheck {

    private static final long SEED = 21;
    /** Whole leagues of 16 bots take long: so many times fewer of them. */
    private static final int FEWER = 200;
    private static final int LEAST_WHOLE = 20;
    private static final double FAR_STEP = 50;
    private static final double EVEN = 0.05;
    /** Elo by which bots are far apart. */
    private static final double FAR = 300;
    /** The last strength with a score of 95% is 5 Elo below. */
    private static final double FARTHEST = 515;
    private static final double BEYOND = 1305;
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

    /** Prints one part, by the word that {@code --only} takes. */
    public void print(String part) throws InterruptedException {
        switch (part) {
            case "fixed" -> fixed();
            case "exact" -> exact();
            case "pairings" -> pairings();
            case "anytime" -> anytime();
            case "rules" -> rules();
            case "sprt" -> sprt();
            case "adaptive" -> adaptive();
            default -> throw new IllegalArgumentException(part);
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
        out.accept(Arrays.stream(cells).map(String::valueOf).collect(Collectors.joining(" | ", "| ", " |")));
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    // ---- the tables ------------------------------------------------------------------------------

    private void fixed() throws InterruptedException {
        head("Bars at a fixed number of clusters: how often they held, and ranges of ranks, in percent.", "league",
            "clusters of a pairing", "scores 5..95%: least", "most", "other scores: least", "ranks: least");
        for (int clusters : new int[] {5, 10, 30, 100, 300}) {
            for (MadeUpLeague league : MadeUpLeagues.small()) {
                fixed(Integer.toString(clusters), FixedCheck.even(league, clusters));
            }
        }
        for (MadeUpLeague league : MadeUpLeagues.paired()) {
            fixed("30 to 400, unequal", new FixedCheck(league, unequal(league.groups().size())));
        }
        for (int clusters : new int[] {5, 30}) {
            fixed(Integer.toString(clusters), FixedCheck.even(MadeUpLeagues.large(), clusters));
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
            + "percent. A cluster is two games.", "clusters", "bars", "0 to 300 Elo apart: least", "mean", "most",
            "300 to 510 Elo apart: least", "mean", "most", "510 to 1300: least");
        for (int clusters : new int[] {30, 40, 60, 100, 200, 300}) {
            ExactCheck check = new ExactCheck(clusters);
            exact(clusters, "these", check.run(0, FAR), check.run(FAR, FARTHEST), check.run(FARTHEST, BEYOND).least());
        }
        for (int clusters : new int[] {30, 40, 60}) {
            OtherBars bars = new OtherBars(2 * clusters);
            exact(clusters, "Wilson's", bars.wilson(0, FAR), bars.wilson(FAR, FARTHEST), Double.NaN);
            exact(clusters, "mid-P", bars.midP(0, FAR), bars.midP(FAR, FARTHEST), Double.NaN);
            exact(clusters, "nearest of all", bars.best(0, FAR), bars.best(FAR, FARTHEST), Double.NaN);
        }
    }

    private void exact(int clusters, String bars, ExactCheck.Outcome near, ExactCheck.Outcome far, double beyond) {
        row(clusters, bars, Coverage.percent(near.least()), Coverage.percent(near.mean()),
            Coverage.percent(near.most()), Coverage.percent(far.least()), Coverage.percent(far.mean()),
            Coverage.percent(far.most()), Coverage.percent(beyond));
    }

    private static int[] unequal(int groups) {
        SplitMix64 random = new SplitMix64(SEED);
        return IntStream.range(0, groups).map(k -> 30 + random.nextInt(371)).toArray();
    }

    private void pairings() throws InterruptedException {
        head("Bars at a fixed number of seeds, by pairing: how often they held, in percent. Of a gauntlet's bars those "
            + "of differences with its bot stand apart.", "league", "pairing", "seeds",
            "clusters of the rarest pairing, mean", "scores 5..95%: least", "most", "other scores: least");
        pairings(MadeUpLeagues.trio(), new int[] {30, 100, 300, 1000}, 0);
        pairings(MadeUpLeagues.mixed(), new int[] {150, 600, 1500, 4000}, 0, 3);
        pairings(MadeUpLeagues.threes(), new int[] {100, 300, 1000}, 0);
        MadeUpLeague gauntlet = MadeUpLeagues.trio().gauntlet(0).comparedWith(MadeUpLeagues.trio().truth());
        pairing(gauntlet, "gauntlet, compared with round robin", false, 200);
    }

    private void pairings(MadeUpLeague league, int[] seeds, int... heroes) throws InterruptedException {
        for (int each : seeds) {
            pairing(league, "adaptive", true, each);
        }
        for (int hero : heroes) {
            MadeUpLeague gauntlet = league.gauntlet(hero);
            for (int clusters : new int[] {10, 30, 100, 300}) {
                pairing(gauntlet, "gauntlet of bot " + (hero + 1), false, clusters * gauntlet.groups().size());
            }
        }
    }

    private void pairing(MadeUpLeague league, String pairing, boolean adaptive, int seeds)
        throws InterruptedException {
        ScheduleCheck.Outcome found = new ScheduleCheck(league, adaptive, StopRule.NONE, seeds)
            .run(threads, leagues, SEED);
        for (Coverage.Among among : among(league)) {
            Coverage bars = found.ofFixed(among);
            row(league.name(), pairing + words(among), seeds, number("%.1f", found.rarest()),
                Coverage.percent(bars.least()), Coverage.percent(bars.most()), Coverage.percent(bars.outer()));
        }
    }

    private static List<Coverage.Among> among(MadeUpLeague league) {
        return league.hero() < 0 ? List.of(Coverage.Among.ALL)
            : List.of(Coverage.Among.WITH_HERO, Coverage.Among.OTHERS);
    }

    private static String words(Coverage.Among among) {
        return among == Coverage.Among.WITH_HERO ? ": with it" : among == Coverage.Among.OTHERS ? ": others" : "";
    }

    private void coverage(MadeUpLeague league, String size, Coverage found) {
        row(league.name(), size, Coverage.percent(found.least()), Coverage.percent(found.most()),
            Coverage.percent(found.outer()));
    }

    private void anytime() throws InterruptedException {
        head("Anytime bars: how often they held at all looks, in percent.", "league", "clusters of a pairing",
            "scores 5..95%: least", "most", "other scores: least");
        for (MadeUpLeague league : MadeUpLeagues.small()) {
            int rounds = league.bots() == 2 ? 3000 : league.bots() < 5 ? 1000 : 300;
            coverage(league, "1 to " + rounds, new AnytimeCheck(league, rounds).run(threads, leagues, SEED));
        }
        MadeUpLeague large = MadeUpLeagues.large();
        coverage(large, "1 to 16", new AnytimeCheck(large, 16).run(threads, leagues, SEED));
    }

    private void rules() throws InterruptedException {
        head("Leagues that are ended by a rule: how often anytime bars held at all looks and at the end, and all that "
            + "was said of the order was true, in percent.", "league", "pairing", "rule", "seeds, mean",
            "bars at all looks: least", "bars at the end: least", "order true");
        for (MadeUpLeague league : MadeUpLeagues.paired()) {
            rules(league, "round robin", false);
            rules(league, "adaptive", true);
            int middle = league.bots() / 2;
            rules(league.gauntlet(middle), "gauntlet of bot " + (middle + 1), false);
        }
        StopRule ranked = new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL);
        for (MadeUpLeague league : MadeUpLeagues.won()) {
            rule(league, "round robin", false, ranked);
            rule(league, "adaptive", true, ranked);
        }
    }

    private void rules(MadeUpLeague league, String pairing, boolean adaptive) throws InterruptedException {
        rule(league, pairing, adaptive, new StopRule(50, false, StopRule.USUAL_EQUAL));
        rule(league, pairing, adaptive, new StopRule(Double.NaN, true, 30));
    }

    private void rule(MadeUpLeague league, String pairing, boolean adaptive, StopRule rule)
        throws InterruptedException {
        ScheduleCheck.Outcome found = new ScheduleCheck(league, adaptive, rule, MOST_DECISIONS)
            .run(threads, leagues, SEED);
        for (Coverage.Among among : among(league)) {
            row(league.name(), pairing + words(among), rule.ranked()
                ? "--until-ranked --equal " + Math.round(rule.equal()) : "--until-bars " + Math.round(rule.bars()),
                Math.round(found.decisions()), Coverage.percent(found.atLooks(among).least()),
                Coverage.percent(found.atEnd(among).least()), rule.ranked() ? Coverage.percent(found.right()) : "-");
        }
    }

    private void sprt() throws InterruptedException {
        head("Sequential tests with alpha = beta = 0.05: how often H1 was accepted, and seeds until the end.", "Elo",
            "games", "truth", "H1 accepted", "seeds, mean", "theory", "of theory");
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double[] elo : new double[][] {{0, 20}, {0, 10}, {-10, 0}, {0, 5}}) {
                for (double ties : new double[] {0, 1}) {
                    for (double at : new double[] {elo[0], elo[1]}) {
                        sprt(new Gsprt(elo[0], elo[1], EVEN, EVEN, model), at, ties, 0);
                    }
                }
            }
        }
        for (Gsprt.Model model : Gsprt.Model.values()) {
            for (double at : new double[] {200, 500, 1000}) {
                for (double elo1 : new double[] {10, 50}) {
                    sprt(new Gsprt(0, elo1, EVEN, EVEN, model), at, 0, 0);
                    sprt(new Gsprt(0, elo1, EVEN, EVEN, model), -at, 0, 0);
                }
                Gsprt far = new Gsprt(at - FAR_STEP, at, EVEN, EVEN, model);
                sprt(far, far.elo0(), 0, 0);
                sprt(far, far.elo1(), 0, 0);
            }
            for (double at : new double[] {0, 10}) {
                sprt(new Gsprt(0, 10, EVEN, EVEN, model), at, 1, 30);
            }
        }
    }

    private void sprt(Gsprt test, double at, double ties, int alike) throws InterruptedException {
        SprtCheck.Outcome found = new SprtCheck(test, at, ties, 100 * ties, alike).run(threads, leagues, SEED);
        row(test.model().name().toLowerCase(Locale.ROOT) + " " + Math.round(test.elo0()) + " to "
            + Math.round(test.elo1()), (ties > 0 ? "ties, seeds of 100 Elo" : "no ties")
            + (alike == 0 ? "" : ", the first " + alike + " seeds even"), Math.round(at),
            number("%.4f", found.accepted()), Math.round(found.mean()), Math.round(found.theory().observations()),
            number("%.3f", found.mean() / found.theory().observations()));
    }

    private void adaptive() throws InterruptedException {
        long whole = Math.max(LEAST_WHOLE, leagues / FEWER);
        head("16 bots until --until-ranked --equal 5, " + whole + " leagues. The last column is the least share with "
            + "which bars would be narrow enough if all strengths were known before.", "steps between neighbours, Elo",
            "round robin, seeds", "adaptive, seeds", "share", "order true", "strengths known");
        double[][] steps = {{10, 60, 20, 50, 30, 40, 15, 55, 25, 45, 35, 60, 20, 50, 30},
            {60, 57, 53, 50, 46, 43, 39, 36, 32, 29, 25, 22, 18, 14, 10}, drawn(1), drawn(2), drawn(3),
            {35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35}};
        StopRule rule = new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL);
        for (double[] each : steps) {
            MadeUpLeague league = MadeUpLeagues.sixteen(each);
            ScheduleCheck.Outcome turns = new ScheduleCheck(league, false, rule, MOST_DECISIONS)
                .run(threads, whole, SEED);
            ScheduleCheck.Outcome learnt = new ScheduleCheck(league, true, rule, MOST_DECISIONS)
                .run(threads, whole, SEED);
            row(Arrays.stream(each).mapToObj(step -> Long.toString(Math.round(step))).collect(Collectors.joining(" ")),
                Math.round(turns.decisions()), Math.round(learnt.decisions()),
                number("%.2f", learnt.decisions() / turns.decisions()), Coverage.percent(learnt.right()),
                number("%.2f", new BestAllocation(league).share()));
        }
    }

    /** Steps by lot. */
    private static double[] drawn(long seed) {
        SplitMix64 random = new SplitMix64(seed);
        return IntStream.range(0, 15).mapToDouble(step -> 10 + random.nextInt(51)).toArray();
    }
}
