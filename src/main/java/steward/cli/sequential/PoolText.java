package steward.cli.sequential;

import java.util.ArrayList;
import java.util.List;
import steward.cli.options.SeedFileOption;
import steward.cli.streams.Colour;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.StoppedRange;
import steward.report.Fields;
import steward.report.Table;
import steward.text.TextFormat;

/**
 * Text about the state of a test against a pool.
 *
 * @param points0  points a game that the new bot is ahead by H0
 * @param points1  by H1
 * @param choosers names of the bots by whose games the seeds were chosen
 */
record PoolText(Gsprt test, double points0, double points1, String one, String base, List<String> choosers) {

    /** Elo of the natural logarithm of odds. */
    private static final double ELO = 400 / StrictMath.log(10);
    /** Opponents that people are shown. */
    private static final int MOST = 12;
    private static final Table<PoolScores.Opponent> OPPONENTS = new Table<PoolScores.Opponent>()
        .left("opponent" + " ".repeat(16), 0, each -> TextFormat.plain(TextFormat.shorten(each.name(), 24)))
        .value("opponent", PoolScores.Opponent::name)
        .value("seeds", PoolScores.Opponent::seeds).shown("seeds", 8)
        .value("new", PoolScores.Opponent::ofNew).shown("new", 9, 3)
        .value("base", PoolScores.Opponent::ofBase).shown("base", 9, 3);
    /** Width of a range of points that says nothing. */
    private static final double VOID = 1;

    /** Returns a line about the test. */
    String heading(int opponents) {
        return TextFormat.plain(one + " - " + base) + " against " + TextFormat.count(opponents, "opponent")
            + ": expected points a game " + signed(points0) + " (H0) or " + signed(points1) + " (H1), alpha "
            + TextFormat.number(test.alpha(), 4) + ", beta " + TextFormat.number(test.beta(), 4);
    }

    private static String signed(double points) {
        String text = TextFormat.number(points, 4);
        return points > 0 ? "+" + text : text;
    }

    /** On one line while it is played. */
    String standing(PoolScores pool) {
        return SprtText.ratio(test, pool.scores()) + ", " + TextFormat.count(pool.scores().observations(), "seed")
            + left(pool);
    }

    private String left(PoolScores pool) {
        return SprtText.left(test, pool.state(test), pool.scores(), pool.gamesOfSeed());
    }

    private String verdict(Gsprt.State state) {
        return switch (state) {
            case H1 -> "H1 is accepted: " + TextFormat.plain(one) + (points0 >= 0 ? " is better against this pool"
                : " is more than " + signed(points0) + " points ahead against this pool");
            case H0 -> "H0 is accepted: " + TextFormat.plain(one) + (points1 <= 0 ? " is worse against this pool"
                : " is less than " + signed(points1) + " points ahead against this pool");
            case OPEN -> "not decided";
        };
    }

    /** Returns the line of the result. */
    String line(PoolScores pool) {
        return SprtText.ratio(test, pool.scores()) + ": " + verdict(pool.state(test)) + left(pool)
            + (choosers.isEmpty() ? "" : "; " + SeedFileOption.flag(choosers));
    }

    /** Returns how it ended or stands. */
    List<String> lines(PoolScores pool, Colour colour) {
        List<String> lines = new ArrayList<>();
        ScoreCounts scores = pool.scores();
        lines.add(heading(pool.opponents().size()));
        lines.add(colour.strong(SprtText.ratio(test, scores) + ": " + verdict(pool.state(test))) + left(pool));
        lines.add(TextFormat.count(scores.observations(), "seed") + ", "
            + TextFormat.count(scores.observations() * pool.gamesOfSeed(), "game")
            + pool.unused().text(", and count as the opponent was drawn"));
        if (scores.observations() > 1) {
            StoppedRange found = test.range(scores);
            double low = 2 * found.scoreLow() - 1;
            double high = 2 * found.scoreHigh() - 1;
            double ahead = pool.ofNew() - pool.ofBase();
            boolean isVoid = high - low > VOID;
            lines.add("Points a game: " + TextFormat.fixed(pool.ofNew(), 4) + ", of the base "
                + TextFormat.fixed(pool.ofBase(), 4) + ": " + fixed(ahead, 4) + (isVoid
                ? ", of too few seeds for a range" : " (" + fixed(low, 4) + " to " + fixed(high, 4) + "), "
                + TextFormat.fixed(100 * (1 - (test.alpha() + test.beta())), 0) + "%"
                + (pool.state(test) == Gsprt.State.OPEN ? " however it ends" : " corrected for stopping")));
            lines.add("In Elo against this pool: " + fixed(elo(pool, ahead), 1) + (isVoid ? "" : " ("
                + fixed(elo(pool, low), 1) + " to " + fixed(elo(pool, high), 1) + ")") + "; H0 "
                + fixed(elo(pool, points0), 1) + ", H1 " + fixed(elo(pool, points1), 1));
            lines.addAll(OPPONENTS.lines(pool.opponents().subList(0, Math.min(MOST, pool.opponents().size()))));
            if (pool.opponents().size() > MOST) {
                lines.add("and " + (pool.opponents().size() - MOST) + " more; --json has all");
            }
        }
        if (!choosers.isEmpty()) {
            lines.add(colour.warning(SeedFileOption.flag(choosers)));
        }
        return lines;
    }

    private static String fixed(double value, int decimals) {
        return Double.isNaN(value) ? "not known" : (value > 0 ? "+" : "") + TextFormat.fixed(value, decimals);
    }

    /**
     * Difference in logistic Elo against the pool of a bot that is so many points ahead of the base, at the base's mean
     * points; NaN where a mean is not between 0 and 1.
     */
    static double elo(PoolScores pool, double ahead) {
        double base = pool.ofBase();
        double other = base + ahead;
        return base > 0 && base < 1 && other > 0 && other < 1
            ? ELO * (StrictMath.log(other / (1 - other)) - StrictMath.log(base / (1 - base))) : Double.NaN;
    }

    Fields fields(PoolScores pool) {
        ScoreCounts scores = pool.scores();
        boolean isAny = scores.observations() > 1;
        StoppedRange found = isAny ? test.range(scores) : null;
        double ahead = pool.ofNew() - pool.ofBase();
        boolean isKnown = isAny && 2 * (found.scoreHigh() - found.scoreLow()) <= VOID;
        double low = isKnown ? 2 * found.scoreLow() - 1 : Double.NaN;
        double high = isKnown ? 2 * found.scoreHigh() - 1 : Double.NaN;
        Fields fields = Fields.of("state", pool.state(test).name(), "points0", Fields.decimal(points0),
            "points1", Fields.decimal(points1)).and(SprtText.fields(test, scores, pool.gamesOfSeed(), pool.unused()))
            .with("level", Fields.decimal(1 - (test.alpha() + test.beta())), "new", pool.ofNew(),
                "base", pool.ofBase(), "ahead", ahead, "aheadLow", low, "aheadHigh", high, "elo", elo(pool, ahead),
                "eloLow", elo(pool, low), "eloHigh", elo(pool, high), "eloOfPoints0", elo(pool, points0),
                "eloOfPoints1", elo(pool, points1));
        if (isAny && pool.state(test) == Gsprt.State.OPEN) {
            fields.with("gamesLeft", SprtText.gamesLeft(test, scores, pool.gamesOfSeed()));
        }
        return fields.with("pool", OPPONENTS.json(pool.opponents()), "choosers", choosers);
    }
}
