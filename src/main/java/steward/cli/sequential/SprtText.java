package steward.cli.sequential;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import steward.cli.streams.Colour;
import steward.json.JsonNumbers;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.StoppedRange;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

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
    record Unused(long without, long allFailed, long repeats) { }

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
        return ratio(scores) + ", " + TextFormat.count(scores.observations(), "seed") + ", score "
            + TextFormat.fixed(scores.mean(), 3) + left(scores);
    }

    private String ratio(ScoreCounts scores) {
        return "LLR " + TextFormat.fixed(test.ratio(scores), 2) + " (" + TextFormat.fixed(test.lower(), 2) + " to "
            + TextFormat.fixed(test.upper(), 2) + ")";
    }

    private String left(ScoreCounts scores) {
        return test.state(scores) != Gsprt.State.OPEN || scores.observations() == 0 ? ""
            : ", about " + TextFormat.count(expectedGames(scores), "game") + " left";
    }

    /** Games that are to be expected until it ends, if things go on as they went. */
    private long expectedGames(ScoreCounts scores) {
        long least = Math.max(1, Gsprt.LEAST - scores.observations());
        double expected = ExpectedLength.of(test, scores, test.ratio(scores)).observations();
        return Math.round(scores.games() * Math.max(least, expected));
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
        lines.add(colour.strong(ratio(scores) + ": " + result) + (unused.repeats() > 0 ? "" : left(scores)));
        lines.add(TextFormat.count(scores.observations(), "seed") + ", "
            + TextFormat.count(scores.observations() * scores.games(), "game") + (unused.without() == 0 ? ""
            : ", " + TextFormat.count(unused.without(), "seed") + " without a result left out")
            + (unused.allFailed() == 0 ? "" : ", " + TextFormat.count(unused.allFailed(), "seed")
            + " left out in which all players failed in the same turn")
            + (unused.repeats() == 0 ? "" : ", " + TextFormat.count(unused.repeats(), "seed")
            + " that only repeat games left out"));
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

    void json(JsonGenerator out, ScoreCounts scores, Unused unused) {
        out.writeStringProperty("state", test.state(scores).name());
        out.writeStringProperty("model", test.model().name().toLowerCase(Locale.ROOT));
        out.writeNumberProperty("elo0", test.elo0());
        out.writeNumberProperty("elo1", test.elo1());
        out.writeNumberProperty("llr", test.ratio(scores));
        out.writeNumberProperty("lower", test.lower());
        out.writeNumberProperty("upper", test.upper());
        out.writeNumberProperty("seeds", scores.observations());
        out.writeNumberProperty("gamesOfSeed", scores.games());
        out.writeNumberProperty("without", unused.without());
        out.writeNumberProperty("allFailed", unused.allFailed());
        out.writeNumberProperty("repeats", unused.repeats());
        out.writeArrayPropertyStart("scores");
        scores.counts().forEach((score, count) -> {
            out.writeStartArray();
            out.writeNumber(score);
            out.writeNumber(count);
            out.writeEndArray();
        });
        out.writeEndArray();
        if (scores.observations() > 1) {
            out.writeNumberProperty("score", scores.mean());
            StoppedRange found = test.range(scores);
            boolean isVoid = isVoid(found);
            String elo = test.model() == Gsprt.Model.NORMALIZED ? "nElo" : "elo";
            out.writeNumberProperty("level", 1 - (test.alpha() + test.beta()));
            write(out, "scoreLow", isVoid, found.scoreLow());
            write(out, "scoreHigh", isVoid, found.scoreHigh());
            write(out, elo, isVoid, found.elo());
            write(out, elo + "Low", isVoid, found.low());
            write(out, elo + "High", isVoid, found.high());
            write(out, "superiority", isVoid, found.superiority());
            if (test.state(scores) == Gsprt.State.OPEN) {
                out.writeNumberProperty("gamesLeft", expectedGames(scores));
            }
        }
    }

    private static void write(JsonGenerator out, String name, boolean isVoid, double value) {
        JsonNumbers.writeOrNull(out, name, isVoid || Double.isInfinite(value) ? Double.NaN : value);
    }
}
