package steward.cli.play;

import java.io.PrintStream;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import steward.cli.streams.Colour;
import steward.contest.AnswerTimes;
import steward.contest.Contest;
import steward.contest.Failure;
import steward.contest.KeptReplays;
import steward.contest.Series;
import steward.contest.Standings;
import steward.contest.Tally;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.ScoreRange;
import steward.match.OwnLimits;
import steward.report.Table;
import steward.text.TextFormat;

/** Result of a series as text for people. */
final class SeriesText {

    private static final int KINDS_SHOWN = 10;
    private static final double PERCENTILE = 0.99;
    private static final int LONGEST_NAME = 40;

    /** One line: how many games of what, the points, and which bots failed how often. */
    static String headline(Series series, Standings standings) {
        StringBuilder line = new StringBuilder(games(series, standings) + ":");
        StringBuilder faults = new StringBuilder();
        for (int k = 0; k < series.contest().entrants().size(); k++) {
            Tally tally = standings.tally(k);
            String name = series.contest().entrants().get(k).name();
            line.append(k == 0 ? " " : ", ").append(name).append(' ').append(series.contest().isAlone()
                ? TextFormat.fixed(tally.points(), 3) + " (mean " + TextFormat.fixed(tally.score(), 2) + ")"
                : TextFormat.fixed(tally.points(), 3));
            if (tally.faults() > 0) {
                faults.append("; ").append(name).append(" failed in ").append(tally.faults());
            }
        }
        int without = standings.games().size() - standings.results();
        if (without > 0) {
            faults.append("; ").append(without).append(" without a result");
        }
        if (!standings.playedAgain().isEmpty()) {
            faults.append("; ").append(standings.playedAgain().size()).append(" played again");
        }
        return TextFormat.plain(line.toString() + faults);
    }

    /** {@code 12 of 40 games of duel}, or {@code 40 games of duel}. */
    private static String games(Series series, Standings standings) {
        int played = standings.games().size();
        return (played < series.games() ? played + " of " : "") + TextFormat.count(series.games(), "game") + " of "
            + series.contest().sceneName();
    }

    static void print(PrintStream out, Colour colour, Series series, Standings standings) {
        int without = standings.games().size() - standings.results();
        out.println(colour.strong(TextFormat.plain(games(series, standings))) + ", "
            + seeds(series)
            + (series.swap() ? ", each with every order of sides" : "")
            + (series.contest().isAlone() ? ", each bot alone" : "")
            + (without > 0 ? ", " + colour.bad(without + " without a result") : "")
            + "; " + TextFormat.fixed(standings.meanTurns(), 1) + " turns on average"
            + (series.contest().hold().isEmpty() ? "" : "; " + series.contest().hold()));
        out.println();
        List<Bot> bots = bots(series, standings);
        points(colour).lines(bots).forEach(out::println);
        TestScores.print(out, series, standings);
        out.println();
        times().lines(bots).forEach(out::println);
        out.println();
        out.println(legend(series.contest()));
        out.println("Times without first answers, which include the start of the program; p99 is at most 1.6% high.");
        double superiority = superiority(series, standings);
        if (!Double.isNaN(superiority)) {
            out.println("Likelihood of superiority of " + TextFormat.plain(series.contest().entrants().get(0).name())
                + ": " + TextFormat.fixed(100 * superiority, 1) + "%");
        }
        repeats(out, series, standings.repeats());
        allFailed(out, colour, series, standings.allFailed());
        FailureReport.print(out, colour, series.contest(), standings.failures());
        playedAgain(out, series, standings.playedAgain());
        replays(out, series, standings.games());
    }

    private static String seeds(Series series) {
        long last = series.starts().at(series.seeds() - 1);
        return series.starts().isListed() ? TextFormat.count(series.seeds(), "listed seed")
            : series.seeds() == 1 ? "seed " + series.first() : "seeds " + series.first() + " to " + last;
    }

    private static String legend(Contest contest) {
        String others = contest.entrants().size() > 2 ? " against each other bot, divided by their number" : "";
        if (!contest.isAlone()) {
            return "Points: 1 for a win, 1/2 for a draw" + others + "; 95% interval by seeds.";
        }
        return contest.entrants().size() == 1 ? "Points: none without another bot on the same maps."
            : "Points: 1 for the better result on the same map, 1/2 for an equal one" + others
                + "; 95% interval by maps.";
    }

    /** Row of the tables: a bot with its points, their 95% interval, and its answer times. */
    record Bot(Contest.Entrant entrant, Tally tally, ScoreRange range, AnswerTimes times) {

        private String name() {
            return TextFormat.plain(TextFormat.shorten(entrant.name(), LONGEST_NAME));
        }

        /** A time in milliseconds, of which there is none without answers. */
        private double ms(ToDoubleFunction<AnswerTimes> nanos) {
            return times.count() > 0 ? nanos.applyAsDouble(times) / TextFormat.NANOS_PER_MS : Double.NaN;
        }
    }

    static List<Bot> bots(Series series, Standings standings) {
        return IntStream.range(0, series.contest().entrants().size()).mapToObj(k -> new Bot(
            series.contest().entrants().get(k), standings.tally(k), ScoreRange.of(scores(series, standings.tally(k))),
            standings.times(k))).toList();
    }

    static Table<Bot> points(Colour colour) {
        return new Table<Bot>().left("bot", 0, Bot::name)
            .value("name", bot -> bot.entrant.name()).value("bot", bot -> bot.entrant.bot())
            .value(OwnLimits.FIELD, bot -> OwnLimits.writtenOrNull(bot.entrant.limits()))
            .value("wins", bot -> bot.tally.wins()).shown("wins", 8)
            .value("draws", bot -> bot.tally.draws()).shown("draws", 8)
            .value("losses", bot -> bot.tally.losses()).shown("losses", 8)
            .value("allFailed", bot -> bot.tally.allFailed())
            .value("faults", bot -> bot.tally.faults()).shown("faults", 8)
            .painted((bot, word) -> bot.tally.faults() > 0 ? colour.bad(word) : word)
            .value("points", bot -> bot.tally.points()).shown("points", 8, 3)
            .painted((bot, word) -> colour.strong(word))
            .value("interval95", bot -> Double.isNaN(bot.tally.points()) ? List.of()
                : List.of(bot.range.low(), bot.range.high()))
            .left("95% interval  ", 3, bot -> Double.isNaN(bot.tally.points()) ? "-"
                : TextFormat.fixed(bot.range.low(), 3) + " to " + TextFormat.fixed(bot.range.high(), 3))
            .value("meanScore", bot -> bot.tally.score()).shown("mean score", 12, 2);
    }

    /** Milliseconds. */
    static Table<Bot> times() {
        return new Table<Bot>().left("bot", 0, Bot::name)
            .value("answers", bot -> bot.times.count()).shown("answers", 8)
            .value("mean", bot -> bot.times.meanNanos() / TextFormat.NANOS_PER_MS).shown("mean ms", 10, 2)
            .value("p99", bot -> bot.ms(times -> times.quantileNanos(PERCENTILE))).shown("p99 ms", 10, 2)
            .value("worst", bot -> bot.ms(AnswerTimes::worstNanos)).shown("worst ms", 10, 2)
            .value("worstGame", bot -> bot.times.count() > 0 ? bot.times.worstGame() : null)
            .value("worstTurn", bot -> bot.times.count() > 0 ? bot.times.worstTurn() : null)
            .value("meanFirst", bot -> bot.times.meanFirstNanos() / TextFormat.NANOS_PER_MS).shown("first ms", 10, 2)
            .value("worstFirst", bot -> Double.isNaN(bot.times.meanFirstNanos()) ? Double.NaN
                : bot.times.worstFirstNanos() / TextFormat.NANOS_PER_MS)
            .left("worst in", 3, bot -> bot.times.count() == 0 ? "" : "game " + bot.times.worstGame() + ", turn "
                + bot.times.worstTurn());
    }

    /** The points of a bot by seed. */
    static ScoreCounts scores(Series series, Tally tally) {
        ScoreCounts scores = new ScoreCounts(series.swap() ? series.contest().players() : 1);
        tally.seeds().forEach(scores::add);
        return scores;
    }

    /** Likelihood of superiority of the first of two bots; NaN for others, and where it is open. */
    static double superiority(Series series, Standings standings) {
        return series.contest().entrants().size() != 2 ? Double.NaN
            : ScoreRange.superiority(scores(series, standings.tally(0)));
    }

    private static void repeats(PrintStream out, Series series, List<Series.Played> games) {
        if (!games.isEmpty()) {
            out.println(TextFormat.count(games.size(), "game") + " of " + series.games() + " (" + FailureReport.more(
                games.stream().limit(FailureReport.GAMES_SHOWN).map(game -> "game " + game.number()).toList(),
                games.size()) + ") only repeat earlier ones, and count once; with --random, for a bot that draws by "
                + "lot, they count.");
        }
    }

    private static void allFailed(PrintStream out, Colour colour, Series series, List<Series.Played> games) {
        if (!games.isEmpty()) {
            List<String> numbers = games.stream().limit(FailureReport.GAMES_SHOWN)
                .map(game -> "game " + game.number()).toList();
            String bots = (series.contest().entrants().size() == 2 ? "Both" : "All") + " bots failed";
            out.println(colour.warning(bots) + " in the same turn in " + TextFormat.count(games.size(), "game") + " ("
                + FailureReport.more(numbers, games.size())
                + "): they count in no points.");
        }
    }

    /** Games that were lost on time on a starved machine, with the evidence. */
    private static void playedAgain(PrintStream out, Series series, List<Series.Played> games) {
        if (games.isEmpty()) {
            return;
        }
        out.println();
        out.println("Played again, since others used the processors (--hiccups count lets the first game count):");
        for (Series.Played game : games.subList(0, Math.min(KINDS_SHOWN, games.size()))) {
            for (Series.Played before = game.starved(); before != null; before = before.starved()) {
                attempt(out, series, before);
            }
        }
        if (games.size() > KINDS_SHOWN) {
            out.println("  and " + TextFormat.count(games.size() - KINDS_SHOWN, "game") + " more; --json lists all");
        }
    }

    private static void attempt(PrintStream out, Series series, Series.Played game) {
        for (Failure failure : game.failures()) {
            out.println(TextFormat.plain("  game " + game.number() + " (seed " + game.seed() + "): "
                + name(series, game, failure.player()) + " in turn " + failure.turn() + ": " + failure.reason()
                + (failure.burner() == null ? "" : "; meanwhile " + name(series, game, failure.burner().player())
                    + " computed on " + TextFormat.fixed(failure.burner().processors(), 2) + " processors")));
        }
        if (game.replay() != null) {
            out.println("    replay: " + game.replay());
        }
    }

    private static String name(Series series, Series.Played game, int player) {
        return series.contest().entrants().get(game.entrantOf(series.contest(), player)).name();
    }

    private static void replays(PrintStream out, Series series, List<Series.Played> games) {
        if (series.folder() == null) {
            return;
        }
        List<Series.Played> kept = games.stream().filter(game -> game.replay() != null).toList();
        out.println();
        if (kept.isEmpty()) {
            out.println("Replays: none (--keep " + series.keep().word() + ")");
            return;
        }
        out.println("Replays: " + (series.keep() == KeptReplays.ALL ? "" : kept.size() + " of "
            + TextFormat.count(games.size(), "game") + " (--keep " + series.keep().word() + "), ")
            + TextFormat.plain(kept.get(0).replay()
                + (kept.size() == 1 ? "" : " to " + kept.get(kept.size() - 1).replay())));
    }
}
