package steward.cli.play;

import java.util.List;
import steward.cli.shared.FailureReason;
import steward.cli.shared.MatchReport;
import steward.cli.streams.Colour;
import steward.contest.Contest;
import steward.contest.Failure;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.contest.Standings;
import steward.contest.loss.Losses;
import steward.match.MatchResult;
import steward.report.Fields;

/**
 * Result of a series for programs: one JSON object on one line. It is the same for any number of threads, except for
 * its last field, {@code times}, and for measurements of late and held bots.
 */
final class SeriesJson {

    /** @param why why the first bot lost, or {@code null} */
    static Fields of(Series series, SeriesPlay play, List<String> choosers, Losses why) {
        Contest contest = series.contest();
        Standings standings = play.standings();
        List<SeriesText.Bot> bots = SeriesText.bots(series, standings);
        Fields fields = Fields.of("scene", contest.sceneName(), "seed", Long.toString(series.first()),
            "seeds", series.seeds(), "choosers", choosers, "swap", series.swap(), "alone", contest.isAlone(),
            "planned", series.games(), "games", standings.games().size(), "results", standings.results(),
            "allFailed", standings.allFailed().size(),
            "repeats", Fields.each(standings.repeats(), Series.Played::number),
            "superiority", SeriesText.superiority(series, standings), "interrupted", play.isBrokenOff(),
            "stopped", play.stopped(), "keep", series.keep().word(), "time", contest.time().basis().word(),
            "hiccups", series.hiccups().word(), "playedAgain", standings.playedAgain().size(),
            "sandbox", contest.sandbox(), "hold", contest.hold(), "meanTurns", standings.meanTurns(),
            "bots", SeriesText.points(Colour.NONE).json(bots), "failures", FailureReport.json(standings.failures()));
        if (why != null) {
            fields.with("why", why.fields());
        }
        return fields.with("list", Fields.each(standings.games(), game -> game(contest, game)),
            "times", SeriesText.times().json(bots));
    }

    private static Fields game(Contest contest, Series.Played game) {
        Fields fields = Fields.of("game", game.number(), "seed", Long.toString(game.seed()), "order",
            Fields.each(contest.players(), player -> contest.entrantOf(player, game.rotation())));
        return (game.result() == null ? fields.with("failure", game.failure())
            : fields.and(result(game.result(), game.failures())))
            .with("replay", game.replay(), "starved", starved(game.starved()));
    }

    /** The game as it was played before, with what it was played again for in turn; null for none. */
    private static Fields starved(Series.Played before) {
        if (before == null) {
            return null;
        }
        Fields fields = result(before.result(), before.failures()).with("replay", before.replay());
        return before.starved() == null ? fields : fields.with("starved", starved(before.starved()));
    }

    private static Fields result(MatchResult result, List<Failure> failures) {
        List<MatchResult.PlayerResult> players = result.players();
        return Fields.of("turns", result.turns(), "ending", result.ending(),
            "ranks", Fields.each(players, MatchResult.PlayerResult::rank),
            "scores", Fields.each(players, MatchResult.PlayerResult::score),
            "faults", Fields.each(players, MatchResult.PlayerResult::fault),
            "faultTurns", Fields.each(players.size(), player -> MatchReport.turnOrNull(failures.stream()
                .filter(each -> each.player() == player).mapToInt(Failure::turn).reduce(0, (before, turn) -> turn))),
            "heldFrom", Fields.each(players, player -> MatchReport.turnOrNull(player.heldFrom())),
            "lateAnswers", Fields.each(failures.stream().filter(failure -> failure.time() != null).toList(),
                SeriesJson::lateAnswer));
    }

    private static Fields lateAnswer(Failure failure) {
        Fields fields = Fields.of("player", failure.player(), "time", FailureReason.time(failure.time()));
        return failure.burner() == null ? fields : fields.with("burner", failure.burner().player(),
            "burnerProcessors", failure.burner().processors());
    }
}
