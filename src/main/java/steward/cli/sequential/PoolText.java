package steward.cli.sequential;

import java.util.ArrayList;
import java.util.List;
import steward.cli.options.SeedFileOption;
import steward.cli.streams.Colour;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.StoppedRange;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

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
    private static final int NAME = 24;
    private static final int OPPONENTS = 12;
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
        ScoreCounts scores = pool.scores();
        return "LLR " + TextFormat.fixed(test.ratio(scores), 2) + " (" + TextFormat.fixed(test.lower(), 2) + " to "
            + TextFormat.fixed(test.upper(), 2) + "), " + TextFormat.count(scores.observations(), "seed") + left(pool);
    }

    private String left(PoolScores pool) {
        ScoreCounts scores = pool.scores();
        return pool.state(test) != Gsprt.State.OPEN || scores.observations() == 0 ? ""
            : ", about " + TextFormat.count(gamesLeft(pool), "game") + " left";
    }

    private long gamesLeft(PoolScores pool) {
        ScoreCounts scores = pool.scores();
        return Math.round(pool.gamesOfSeed() * Math.max(Math.max(1, Gsprt.LEAST - scores.observations()),
            ExpectedLength.of(test, scores, test.ratio(scores)).observations()));
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
        return standing(pool).replaceFirst(", .*", "") + ": " + verdict(pool.state(test)) + left(pool)
            + (choosers.isEmpty() ? "" : "; " + SeedFileOption.flag(choosers));
    }

    /** Returns how it ended or stands. */
    List<String> lines(PoolScores pool, Colour colour) {
        List<String> lines = new ArrayList<>();
        ScoreCounts scores = pool.scores();
        SprtText.Unused unused = pool.unused();
        lines.add(heading(pool.opponents().size()));
        lines.add(colour.strong(standing(pool).replaceFirst(", .*", "") + ": " + verdict(pool.state(test)))
            + left(pool));
        lines.add(TextFormat.count(scores.observations(), "seed") + ", "
            + TextFormat.count(scores.observations() * pool.gamesOfSeed(), "game") + text(unused.without(),
                " without a result left out") + text(unused.allFailed(), " left out in which all players failed in "
                + "the same turn") + text(unused.repeats(), " that only repeat games, and count as the "
                + "opponent was drawn"));
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
            lines.add(TextFormat.left("opponent", NAME) + "   seeds      new     base");
            pool.opponents().stream().limit(OPPONENTS).forEach(each -> lines.add(TextFormat.left(TextFormat.plain(
                TextFormat.shorten(each.name(), NAME)), NAME) + TextFormat.right(Long.toString(each.seeds()), 8)
                + TextFormat.right(TextFormat.fixed(each.ofNew(), 3), 9)
                + TextFormat.right(TextFormat.fixed(each.ofBase(), 3), 9)));
            if (pool.opponents().size() > OPPONENTS) {
                lines.add("and " + (pool.opponents().size() - OPPONENTS) + " more; --json has all");
            }
        }
        if (!choosers.isEmpty()) {
            lines.add(colour.warning(SeedFileOption.flag(choosers)));
        }
        return lines;
    }

    private static String text(long seeds, String what) {
        return seeds == 0 ? "" : ", " + TextFormat.count(seeds, "seed") + what;
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

    void json(JsonGenerator out, PoolScores pool) {
        ScoreCounts scores = pool.scores();
        SprtText.Unused unused = pool.unused();
        out.writeStringProperty("state", pool.state(test).name());
        out.writeNumberProperty("points0", points0);
        out.writeNumberProperty("points1", points1);
        out.writeNumberProperty("llr", test.ratio(scores));
        out.writeNumberProperty("lower", test.lower());
        out.writeNumberProperty("upper", test.upper());
        out.writeNumberProperty("seeds", scores.observations());
        out.writeNumberProperty("gamesOfSeed", pool.gamesOfSeed());
        out.writeNumberProperty("without", unused.without());
        out.writeNumberProperty("allFailed", unused.allFailed());
        out.writeNumberProperty("repeats", unused.repeats());
        boolean isAny = scores.observations() > 1;
        StoppedRange found = isAny ? test.range(scores) : null;
        double ahead = pool.ofNew() - pool.ofBase();
        boolean isKnown = isAny && 2 * (found.scoreHigh() - found.scoreLow()) <= VOID;
        double low = isKnown ? 2 * found.scoreLow() - 1 : Double.NaN;
        double high = isKnown ? 2 * found.scoreHigh() - 1 : Double.NaN;
        out.writeNumberProperty("level", 1 - (test.alpha() + test.beta()));
        JsonNumbers.writeOrNull(out, "new", pool.ofNew());
        JsonNumbers.writeOrNull(out, "base", pool.ofBase());
        JsonNumbers.writeOrNull(out, "ahead", ahead);
        JsonNumbers.writeOrNull(out, "aheadLow", low);
        JsonNumbers.writeOrNull(out, "aheadHigh", high);
        JsonNumbers.writeOrNull(out, "elo", elo(pool, ahead));
        JsonNumbers.writeOrNull(out, "eloLow", elo(pool, low));
        JsonNumbers.writeOrNull(out, "eloHigh", elo(pool, high));
        JsonNumbers.writeOrNull(out, "eloOfPoints0", elo(pool, points0));
        JsonNumbers.writeOrNull(out, "eloOfPoints1", elo(pool, points1));
        if (isAny && pool.state(test) == Gsprt.State.OPEN) {
            out.writeNumberProperty("gamesLeft", gamesLeft(pool));
        }
        JsonObject.writeAll(out, "pool", pool.opponents(), each -> {
            out.writeStringProperty("opponent", each.name());
            out.writeNumberProperty("seeds", each.seeds());
            JsonNumbers.writeOrNull(out, "new", each.ofNew());
            JsonNumbers.writeOrNull(out, "base", each.ofBase());
        });
        JsonObject.writeTexts(out, "choosers", choosers);
    }
}
