package steward.cli.sequential;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import steward.cli.streams.Colour;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.StoppedRange;
import steward.report.Fields;
import steward.text.TextFormat;

/** Text and JSON about the state of a sequential test. */
record SprtText(Gsprt test, String one, String other) {

    /** Width of a range of scores that says nothing: a bot that has won all may be the worse one. */
    private static final double VOID = 0.5;

    /**
     * Seeds that the test does not use.
     *
     * @param without   a game of which has no result
     * @param allFailed in a game of which all players failed in the same turn
     * @param repeats   that only repeat games
     */
    record Unused(long without, long allFailed, long repeats) {

        /** @param ofRepeats what becomes of those that only repeat games */
        String text(String ofRepeats) {
            return text(without, " without a result left out")
                + text(allFailed, " left out in which all players failed in the same turn")
                + text(repeats, " that only repeat games" + ofRepeats);
        }

        private static String text(long seeds, String what) {
            return seeds == 0 ? "" : ", " + TextFormat.count(seeds, "seed") + what;
        }
    }

    /** Elo by the mean score, nElo by standard deviations: the two are told apart wherever a number stands. */
    private String unit() {
        return test.model() == Gsprt.Model.NORMALIZED ? "nElo" : "Elo";
    }

    /** Returns a line about the test: the bots, the hypotheses, the error rates. */
    String heading() {
        return TextFormat.plain(one + " - " + other) + ": " + unit() + " " + number(test.elo0()) + " (H0) or "
            + number(test.elo1()) + " (H1), alpha " + number(test.alpha()) + ", beta " + number(test.beta());
    }

    private static String number(double value) {
        return TextFormat.number(value, 4);
    }

    /** On one line while it is played. */
    String standing(ScoreCounts scores) {
        return ratio(test, scores) + ", " + TextFormat.count(scores.observations(), "seed") + ", score "
            + TextFormat.fixed(scores.mean(), 3) + left(test, test.state(scores), scores, scores.games());
    }

    static String ratio(Gsprt test, ScoreCounts scores) {
        return "LLR " + TextFormat.fixed(test.ratio(scores), 2) + " (" + TextFormat.fixed(test.lower(), 2) + " to "
            + TextFormat.fixed(test.upper(), 2) + ")";
    }

    /** {@code , about 200 games left} of an open test, or nothing. @param games of a seed */
    static String left(Gsprt test, Gsprt.State state, ScoreCounts scores, int games) {
        return state != Gsprt.State.OPEN || scores.observations() == 0 ? ""
            : ", about " + TextFormat.count(gamesLeft(test, scores, games), "game") + " left";
    }

    /** Games that are to be expected until it ends, if things go on as they went. */
    static long gamesLeft(Gsprt test, ScoreCounts scores, int games) {
        long least = Math.max(1, Gsprt.LEAST - scores.observations());
        return Math.round(games * Math.max(least,
            ExpectedLength.of(test, scores, test.ratio(scores)).observations()));
    }

    /** Returns how it ended or stands. */
    List<String> lines(ScoreCounts scores, Unused unused, Colour colour) {
        List<String> lines = new ArrayList<>();
        Gsprt.State state = test.state(scores);
        String result = switch (state) {
            case H1 -> "H1 is accepted: " + TextFormat.plain(one) + (test.elo0() >= 0 ? " is better"
                : " is more than " + number(test.elo0()) + " " + unit() + " ahead");
            case H0 -> "H0 is accepted: " + TextFormat.plain(one) + (test.elo1() <= 0 ? " is worse"
                : " is less than " + number(test.elo1()) + " " + unit() + " ahead");
            case OPEN -> "not decided";
        };
        lines.add(heading());
        lines.add(colour.strong(ratio(test, scores) + ": " + result) + (unused.repeats() > 0 ? ""
            : left(test, state, scores, scores.games())));
        lines.add(TextFormat.count(scores.observations(), "seed") + ", "
            + TextFormat.count(scores.observations() * scores.games(), "game") + unused.text(" left out"));
        lines.add("Scores by seed: " + scores.counts().entrySet().stream().filter(each -> each.getValue() > 0)
            .map(each -> TextFormat.number(each.getKey(), 3) + " " + each.getValue() + " times")
            .collect(Collectors.joining(", ")));
        if (scores.observations() > 1) {
            StoppedRange found = test.range(scores);
            lines.add("Score " + TextFormat.fixed(scores.mean(), 4) + (isVoid(found) ? ", of too few seeds for a bar"
                : ", " + unit() + " " + elo(found) + ", " + percent(1 - (test.alpha() + test.beta()), 0)
                + (state == Gsprt.State.OPEN ? " if it ended here" : " corrected for stopping")
                + "; likelihood of superiority " + percent(found.superiority(), 1)));
        }
        return lines;
    }

    private static String percent(double share, int digits) {
        return TextFormat.fixed(100 * share, digits) + "%";
    }

    /** True if the range of scores is too wide to say anything. */
    private static boolean isVoid(StoppedRange found) {
        return found.scoreHigh() - found.scoreLow() > VOID;
    }

    private static String elo(StoppedRange found) {
        return Double.isInfinite(found.high()) ? "> " + signed(found.low())
            : Double.isInfinite(found.low()) ? "< " + signed(found.high())
            : signed(found.elo()) + " (" + signed(found.low()) + " to " + signed(found.high()) + ")";
    }

    /** One decimal, with its sign unless that is a zero. */
    private static String signed(double elo) {
        String text = TextFormat.fixed(elo, 1);
        return text.startsWith("-") || Double.parseDouble(text) == 0 ? text : "+" + text;
    }

    Fields fields(ScoreCounts scores, Unused unused) {
        Fields fields = Fields.of("state", test.state(scores).name(), "model", test.model(),
            "elo0", Fields.decimal(test.elo0()), "elo1", Fields.decimal(test.elo1()))
            .and(fields(test, scores, scores.games(), unused))
            .with("scores", Fields.each(scores.counts().entrySet(),
                each -> List.of(Fields.decimal(each.getKey()), each.getValue())));
        if (scores.observations() > 1) {
            StoppedRange found = test.range(scores);
            boolean isVoid = isVoid(found);
            String elo = test.model() == Gsprt.Model.NORMALIZED ? "nElo" : "elo";
            fields.with("score", Fields.decimal(scores.mean()),
                "level", Fields.decimal(1 - (test.alpha() + test.beta())),
                "scoreLow", isVoid ? null : found.scoreLow(), "scoreHigh", isVoid ? null : found.scoreHigh(),
                elo, isVoid ? null : found.elo(), elo + "Low", isVoid ? null : found.low(),
                elo + "High", isVoid ? null : found.high(), "superiority", isVoid ? null : found.superiority());
            if (test.state(scores) == Gsprt.State.OPEN) {
                fields.with("gamesLeft", gamesLeft(test, scores, scores.games()));
            }
        }
        return fields;
    }

    /** Ratio and counts. @param games of a seed */
    static Fields fields(Gsprt test, ScoreCounts scores, int games, Unused unused) {
        return Fields.of("llr", Fields.decimal(test.ratio(scores)), "lower", Fields.decimal(test.lower()),
            "upper", Fields.decimal(test.upper()), "seeds", scores.observations(), "gamesOfSeed", games,
            "without", unused.without(), "allFailed", unused.allFailed(), "repeats", unused.repeats());
    }
}
