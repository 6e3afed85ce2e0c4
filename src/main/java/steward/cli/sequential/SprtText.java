package steward.cli.sequential;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import steward.cli.streams.Colour;
import steward.json.JsonNumbers;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.SequentialBar;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

/** Text on the state of a test, for people and for programs. */
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

    private String model() {
        return test.model().name().toLowerCase(Locale.ROOT);
    }

    /** Returns a line about the test: the bots, the hypotheses, the error rates. */
    String heading() {
        return TextFormat.plain(one + " - " + other) + ": " + model() + " Elo " + number(test.elo0()) + " (H0) or "
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
            case H1 -> "H1 is accepted: " + TextFormat.plain(one) + " is better";
            case H0 -> "H0 is accepted: " + TextFormat.plain(one) + " is not better by so much";
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
            lines.add("Score " + TextFormat.fixed(scores.mean(), 4) + (isVoid(scores)
                ? ", of too few seeds for a bar"
                : " (" + range(SequentialBar.ofMean(scores), mean -> TextFormat.fixed(mean, 4)) + "), " + elo(scores)
                + ", 95% at any time"));
        }
        return lines;
    }

    /** True if the range of scores is too wide to say anything. */
    private static boolean isVoid(ScoreCounts scores) {
        SequentialBar bar = SequentialBar.ofMean(scores);
        return Math.min(1, bar.high()) - Math.max(0, bar.low()) > VOID;
    }

    private static String range(SequentialBar bar, DoubleFunction<String> form) {
        String low = form.apply(bar.low());
        String high = form.apply(bar.high());
        return bar.isOpenAbove() ? "> " + low : bar.isOpenBelow() ? "< " + high : low + " to " + high;
    }

    private String elo(ScoreCounts scores) {
        SequentialBar bar = test.range(scores);
        String range = range(bar, SprtText::signed);
        return model() + " Elo " + (bar.isOpenAbove() || bar.isOpenBelow() ? range
            : signed(test.elo(scores.mean(), scores)) + " (" + range + ")");
    }

    /** One decimal, with its sign unless that is a zero. */
    private static String signed(double elo) {
        String text = TextFormat.fixed(elo, 1);
        return text.startsWith("-") || Double.parseDouble(text) == 0 ? text : "+" + text;
    }

    void json(JsonGenerator out, ScoreCounts scores, Unused unused) {
        out.writeStringProperty("state", test.state(scores).name());
        out.writeStringProperty("model", model());
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
            json(out, "score", SequentialBar.ofMean(scores), isVoid(scores));
            SequentialBar elo = test.range(scores);
            JsonNumbers.writeOrNull(out, "elo", elo.isOpenAbove() || elo.isOpenBelow() ? Double.NaN
                : test.elo(scores.mean(), scores));
            json(out, "elo", elo, isVoid(scores));
            if (test.state(scores) == Gsprt.State.OPEN) {
                out.writeNumberProperty("gamesLeft", expectedGames(scores));
            }
        }
    }

    private static void json(JsonGenerator out, String name, SequentialBar bar, boolean isVoid) {
        JsonNumbers.writeOrNull(out, name + "Low", isVoid || bar.isOpenBelow() ? Double.NaN : bar.low());
        JsonNumbers.writeOrNull(out, name + "High", isVoid || bar.isOpenAbove() ? Double.NaN : bar.high());
    }
}
