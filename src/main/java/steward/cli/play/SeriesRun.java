package steward.cli.play;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import steward.cli.options.SeedFileOption;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Verbosity;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.Streams;
import steward.contest.Losers;
import steward.contest.ProgramWatch;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.contest.Standings;
import steward.contest.loss.Losses;
import steward.text.TextFormat;

/**
 * Run of a series, with a report of the result, also if it is interrupted.
 *
 * @param report how much is said
 * @param strict whether a bot that fails makes the exit status 1
 * @param random whether bots draw by lot, so that equal games are no repeats
 * @param choosers names of the bots by whose games the seeds were chosen
 * @param why    whether it is said why the first bot lost
 * @param page   of the series
 */
record SeriesRun(Streams streams, Series series, Verbosity report, boolean strict, boolean random,
                 List<String> choosers, boolean why, SeriesPage page) {

    /** How many games without a result are reported one by one. */
    private static final int PROBLEMS_SHOWN = 10;

    private static final int LONGEST_NAME = 12;

    /** @return the exit status: not 0 if a game has no result */
    int play(int threads, boolean overwrite) throws InterruptedException {
        return play(threads, overwrite, null, StoredSeries.watch(series.contest(), streams));
    }

    /**
     * Plays.
     *
     * @param keeper is told of every game that is over, by any thread, and what it throws ends the series; or
     *               {@code null}. With it, the table of a program that became another one is not printed
     * @param watch  over the programs: when one becomes another, the series ends
     */
    int play(int threads, boolean overwrite, Consumer<Series.Played> keeper, ProgramWatch watch)
            throws InterruptedException {
        series.prepare(overwrite);
        SeriesPlay play = new SeriesPlay(series, overwrite, watch);
        if (random) {
            play.standings().random();
        }
        if (why && !series.contest().setup().isGuest()) {
            play.followLeads();                        // nobody knows the standing of a guest's game before its end
        }
        if (report == Verbosity.FULL && series.games() != series.seeds()) {
            streams.err().println(TextFormat.count(series.seeds(), "seed") + ", "
                + TextFormat.count(series.games(), "game"));
        }
        ProgressLine progress = report == Verbosity.LINE ? null
            : ProgressLine.watched(streams, "games", series.games());
        try (Interruption interruption = new Interruption(streams, () -> interrupted(play, progress))) {
            play.play(threads, game -> {
                if (keeper != null) {
                    keeper.accept(game);
                }
                if (progress != null) {
                    progress.step(standing(play.standings()));
                }
            });
            if (!interruption.over()) {
                return ExitStatus.FAILED;              // the process is about to end, with the status of its signal
            }
        } finally {
            if (progress != null) {
                progress.close();
            }
        }
        if (keeper == null || play.changed() == null) {
            tell(play);
            page.write(streams, series, play, choosers, report == Verbosity.FULL);
        }
        tellProblems(play);
        boolean whole = play.stopped() == null && play.standings().results() == series.games();
        boolean faults = play.standings().gamesWithFaults() > 0;
        return !whole || strict && faults ? ExitStatus.FAILED : ExitStatus.DONE;
    }

    /** The points of the first bot so far. */
    private String standing(Standings standings) {
        String name = TextFormat.shorten(series.contest().entrants().get(0).name(), LONGEST_NAME);
        return name + " " + TextFormat.fixed(standings.points(0), 3);
    }

    /** Called at Ctrl-C, on another thread than the playing ones. */
    private String interrupted(SeriesPlay play, ProgressLine progress) {
        List<Path> cut = play.breakOff();
        if (progress != null) {
            progress.close();
        }
        int games = play.standings().games().size();
        if (games > 0 || report == Verbosity.JSON) {
            tell(play);
        }
        streams.out().flush();
        return (games == 0 ? "no game was complete" : games + " of " + TextFormat.count(series.games(), "game")
            + (games == 1 ? " was" : " were") + " complete and count") + (cut.isEmpty() ? ""
            : "; replays that were cut off: " + String.join(" ", cut.stream().map(Path::toString).toList()));
    }

    private void tell(SeriesPlay play) {
        switch (report) {
            case JSON -> Json.print(streams, SeriesJson.of(series, play, choosers, losses(play)));
            case LINE -> streams.out().println(SeriesText.headline(series, play.standings())
                + (choosers.isEmpty() ? "" : "; " + SeedFileOption.flag(choosers)));
            default -> {
                SeriesText.print(streams.out(), streams.outColour(), series, play.standings());
                if (why) {
                    streams.out().println();
                    losses(play).lines().forEach(streams.out()::println);
                }
                if (!choosers.isEmpty()) {
                    streams.out().println(streams.outColour().warning(SeedFileOption.flag(choosers)));
                }
            }
        }
    }

    /** The account of the games that the first bot lost, or {@code null}. */
    private Losses losses(SeriesPlay play) {
        return why ? Losers.of(series.contest(), play.standings().games(), play.standings().repeats(), 0)
            : null;
    }

    private void tellProblems(SeriesPlay play) {
        int problems = 0;
        for (Series.Played game : play.standings().games()) {
            if (game.result() == null && problems++ < PROBLEMS_SHOWN) {
                streams.err().println("steward: game " + game.number() + " could not be brought to a result: "
                    + TextFormat.plain(game.failure()));
            }
        }
        if (problems > PROBLEMS_SHOWN) {
            streams.err().println("steward: and " + TextFormat.count(problems - PROBLEMS_SHOWN, "game") + " more");
        }
        if (play.changed() != null) {
            streams.err().println("steward: the series ends after " + play.standings().games().size() + " of "
                + TextFormat.count(series.games(), "game") + ": " + TextFormat.plain(play.changed())
                + " has changed, and one table is of one version of each bot; those that were over count");
        }
        if (play.stopped() != null) {
            streams.err().println("steward: the series ends after " + play.standings().games().size() + " of "
                + TextFormat.count(series.games(), "game") + ", because a replay could not be written; "
                + "make room, or call with --keep none");
        }
    }
}
