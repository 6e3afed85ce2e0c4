package steward.cli.play;

import java.io.PrintStream;
import java.util.List;
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
import steward.text.TextFormat;

/** Result of a series as text for people. */
final class SeriesText {

    private static final int KINDS_SHOWN = 10;
    private static final double NANOS_PER_MS = 1e6;
    static final double PERCENTILE = 0.99;

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
        points(out, colour, series, standings);
        TestScores.print(out, series, standings);
        out.println();
        times(out, series, standings);
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

    private static int nameWidth(Series series) {
        int width = series.contest().entrants().stream().mapToInt(entrant -> entrant.name().length()).max().orElse(0);
        return Math.min(40, Math.max(3, width));
    }

    private static String name(Contest.Entrant entrant, int width) {
        return TextFormat.left(TextFormat.plain(TextFormat.shorten(entrant.name(), width)), width);
    }

    private static void points(PrintStream out, Colour colour, Series series, Standings standings) {
        int names = nameWidth(series);
        out.println(TextFormat.left("bot", names)
            + "    wins   draws  losses  faults  points   95% interval    mean score");
        for (int k = 0; k < series.contest().entrants().size(); k++) {
            Tally tally = standings.tally(k);
            String faults = TextFormat.right(Integer.toString(tally.faults()), 8);
            out.println(name(series.contest().entrants().get(k), names)
                + TextFormat.right(Integer.toString(tally.wins()), 8)
                + TextFormat.right(Integer.toString(tally.draws()), 8)
                + TextFormat.right(Integer.toString(tally.losses()), 8)
                + (tally.faults() > 0 ? colour.bad(faults) : faults)
                + colour.strong(TextFormat.right(TextFormat.fixed(tally.points(), 3), 8))
                + "   " + TextFormat.left(interval(series, tally), 14)
                + TextFormat.right(TextFormat.fixed(tally.score(), 2), 12));
        }
    }

    private static String interval(Series series, Tally tally) {
        ScoreRange range = ScoreRange.of(scores(series, tally));
        return Double.isNaN(tally.points()) ? "-" : TextFormat.fixed(range.low(), 3) + " to "
            + TextFormat.fixed(range.high(), 3);
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

    private static void times(PrintStream out, Series series, Standings standings) {
        int names = nameWidth(series);
        out.println(TextFormat.left("bot", names) + " answers   mean ms    p99 ms  worst ms  first ms   worst in");
        for (int k = 0; k < series.contest().entrants().size(); k++) {
            AnswerTimes times = standings.times(k);
            boolean any = times.count() > 0;
            out.println(name(series.contest().entrants().get(k), names)
                + TextFormat.right(Long.toString(times.count()), 8)
                + TextFormat.right(TextFormat.fixed(times.meanNanos() / NANOS_PER_MS, 2), 10)
                + TextFormat.right(any ? TextFormat.ms(times.quantileNanos(PERCENTILE)) : "-", 10)
                + TextFormat.right(any ? TextFormat.ms(times.worstNanos()) : "-", 10)
                + TextFormat.right(TextFormat.fixed(times.meanFirstNanos() / NANOS_PER_MS, 2), 10)
                + (any ? "   game " + times.worstGame() + ", turn " + times.worstTurn() : ""));
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
