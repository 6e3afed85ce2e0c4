package steward.cli.play;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import steward.cli.options.DisplayOptions;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.MatchReport;
import steward.cli.shared.Pages;
import steward.cli.shared.Verbosity;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.CountedGame;
import steward.contest.Hiccups;
import steward.contest.ReplayFile;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.replay.page.UnclosedOutputStream;
import steward.text.TextFormat;

/**
 * One match and the report of its result. If a bot lost on time because others used the processors, the match is played
 * again, unless it has been shown already: watched live, on the standard output, or in a pipe.
 *
 * @param report  how much is said
 * @param strict  whether a bot that fails makes the exit status 1
 * @param piped   whether the standard output is the replay; then all else is said on the standard error
 * @param hiccups what becomes of a match that was lost so
 */
record SingleMatch(Streams streams, Contest contest, Verbosity report, boolean strict, boolean piped,
                   Hiccups hiccups) {

    private static final MatchListener NOBODY = new MatchListener() { };

    /**
     * A match that is not shown.
     *
     * @param file for the replay, or {@code null}
     * @return the exit status
     */
    int play(long seed, Path file, boolean overwrite) throws InterruptedException {
        return tell(seed, counted(seed, file, overwrite, null), file);
    }

    /** As {@link #play(long, Path, boolean)}; the match is shown as the options say. */
    int play(long seed, Path file, boolean overwrite, DisplayOptions options) throws InterruptedException {
        PrintStream said = report == Verbosity.FULL ? text() : streams.err();
        try (MatchDisplay show = MatchDisplay.prepare(streams, said, options, Pages.title(names()), file, overwrite)) {
            int status = tell(seed, counted(seed, file, overwrite, show), file);
            streams.out().flush();
            show.finish();
            return status;
        }
    }

    private CountedGame<MatchListener> counted(long seed, Path path, boolean overwrite, MatchDisplay show)
            throws InterruptedException {
        boolean shown = piped || show != null && show.isWatched() || path != null && Files.exists(path)
            && !Files.isRegularFile(path);
        AtomicReference<ReplayFile> recording = new AtomicReference<>(open(path, overwrite));
        AtomicBoolean begun = new AtomicBoolean();
        CountedGame<MatchListener> game;
        try {
            if (show != null) {
                show.awaitViewer();
            }
            try (Interruption hint = new Interruption(streams, path == null ? null : () -> recording.get().exists()
                    ? "the turns so far are in " + path : "no turn was played")) {
                game = CountedGame.play(contest, seed, shown ? Hiccups.COUNT : hiccups, () -> follower(seed), () -> {
                    if (begun.getAndSet(true) && path != null) {
                        recording.get().close();
                        recording.set(open(path, true));
                    }
                    OutputStream file = piped ? streams.out() : recording.get();
                    OutputStream all = show == null ? file : show.with(file);
                    return all == null ? null : new UnclosedOutputStream(all);
                });
                hint.over();
            }
        } catch (UncheckedIOException | IOException problem) {
            throw withoutResult(recording.get(), problem.getMessage());
        } finally {
            if (path != null) {
                recording.get().close();
            }
        }
        if (path != null && recording.get().isBroken()) {
            throw withoutResult(recording.get(), null);
        }
        game.again().forEach(streams::warn);
        if (game.discarded() != null) {
            throw withoutResult(null, game.discarded());
        }
        return game;
    }

    private static ReplayFile open(Path path, boolean overwrite) {
        return path == null ? null : new ReplayFile(path, overwrite);
    }

    private static FailedException withoutResult(ReplayFile recording, String problem) {
        if (recording != null) {
            recording.removeIfEmpty();
        }
        return new FailedException("the match could not be brought to a result: "
            + (recording != null && recording.isBroken() ? recording.problem() : problem));
    }

    private int tell(long seed, CountedGame<?> game, Path file) {
        MatchResult result = game.result();
        switch (report) {
            case JSON -> Json.print(streams, MatchReport.fields(contest, seed, game, file));
            case LINE -> text().println(MatchReport.headline(contest.sceneName(), seed, result, game.failures()));
            default -> {
                MatchReport.print(text(), piped ? streams.errColour() : streams.outColour(), contest.sceneName(), seed,
                    result, game.failures());
                if (file != null) {
                    MatchReport.printReplay(text(), file, contest.setup().scene().gameId());
                }
            }
        }
        return strict && result.anyFault() ? ExitStatus.FAILED : ExitStatus.DONE;
    }

    private PrintStream text() {
        return piped ? streams.err() : streams.out();
    }

    private List<String> names() {
        return contest.entrants().stream().map(Contest.Entrant::name).toList();
    }

    private MatchListener follower(long seed) {
        if (report != Verbosity.FULL || piped || !streams.outTerminal()) {
            return NOBODY;
        }
        List<String> names = names();
        streams.out().println(contest.sceneName() + ", seed " + seed + ": "
            + TextFormat.plain(String.join(" against ", names)));
        streams.out().flush();
        return new TurnProgress(streams, names);
    }
}
