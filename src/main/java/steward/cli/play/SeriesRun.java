package steward.cli.play;

import java.util.List;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.ProgressLine;
import steward.cli.shared.Streams;
import steward.cli.shared.Verbosity;
import steward.contest.Series;
import steward.text.TextFormat;

/**
 * Plays a series and tells how it went.
 *
 * @param report how much is said
 * @param strict whether a bot that fails makes the exit status 1
 */
record SeriesRun(Streams streams, Series series, Verbosity report, boolean strict) {

    /** @return the exit status: not 0 if a game has no result */
    int play(int threads, boolean overwrite) throws InterruptedException {
        series.prepare(overwrite);
        List<Series.Played> games;
        if (report == Verbosity.LINE || !streams.errTerminal()) {
            games = series.play(threads, overwrite, () -> { });
        } else {
            try (ProgressLine progress = new ProgressLine(streams.err(), series.games())) {
                games = series.play(threads, overwrite, progress::step);
            }
        }
        switch (report) {
            case JSON -> SeriesJson.print(streams, series, games);
            case LINE -> streams.out().println(SeriesText.headline(series, games));
            default -> SeriesText.print(streams, series, games);
        }
        for (Series.Played game : games) {
            if (game.result() == null) {
                streams.err().println("steward: game " + game.number() + " could not be brought to a result: "
                    + TextFormat.plain(game.failure()));
            }
        }
        boolean whole = games.stream().allMatch(game -> game.result() != null);
        boolean faults = games.stream().anyMatch(game -> game.result() != null && game.result().anyFault());
        return !whole || strict && faults ? ExitStatus.FAILED : ExitStatus.DONE;
    }
}
