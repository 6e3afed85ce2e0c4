package steward.cli.play;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntFunction;
import steward.cli.options.SeedOption;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.FailureReason;
import steward.cli.shared.Pages;
import steward.cli.streams.Streams;
import steward.codingame.GameResultLog;
import steward.codingame.GameResultScores;
import steward.contest.Contest;
import steward.contest.CountedGame;
import steward.contest.Failure;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.match.MatchListener;
import steward.match.MatchResult;
import tools.jackson.core.JacksonException;

/**
 * One match for an arena tool: played, its scores printed, and the requested game result, replay and page written.
 * Existing files are replaced if {@link RefereeFiles} permits it.
 *
 * @param log    for the game result in JSON, or {@code null}
 * @param replay for our replay, or {@code null}
 * @param page   whether a page is made beside the replay
 */
record RefereeGame(Streams streams, Contest contest, Path log, Path replay, boolean page) {

    private static final MatchListener NO_LISTENER = new MatchListener() { };

    /**
     * @param wanted the seed, or {@code null} for any
     * @return the exit status
     */
    int play(Long wanted) throws InterruptedException {
        long seed = wanted == null ? SeedOption.draw() : wanted;
        Path recording = replay == null && page ? temporary() : replay;
        try (OutputStream logStream = log == null ? null : OutputFiles.open(log, true)) {
            CountedGame<?> game = counted(seed, logStream != null, recording);
            tell(streams, contest, game.failures(), player -> "-p" + (player + 1));
            printScores(game.result(), wanted == null ? "seed=" + seed : null);
            if (game.follower() instanceof GameResultLog gameResult) {
                gameResult.write(new BufferedOutputStream(logStream), contest.sceneName(), seed, game.result());
            }
        } catch (UncheckedIOException | JacksonException problem) {
            throw new FailedException("the match could not be brought to a result: " + problem.getMessage());
        } catch (IOException problem) {
            throw new FailedException("a file cannot be closed: " + problem.getMessage());
        }
        if (page) {
            streams.out().println("replay: " + recording);
            streams.out().println("page: " + makePage(recording));
        }
        return ExitStatus.DONE;
    }

    /** Plays the game. A tool that finds no scores takes it for a draw: if it has no result, each bot gets -1. */
    private CountedGame<?> counted(long seed, boolean logged, Path recording)
            throws IOException, InterruptedException {
        try {
            CountedGame<?> game = CountedGame.play(contest, seed, () -> logged ? new GameResultLog() : NO_LISTENER,
                () -> recording == null ? null : OutputFiles.open(recording, true));
            tell(streams, game);
            return game;
        } catch (InputException refused) {
            throw refused;                                  // who refuses the call says so
        } catch (RuntimeException | OutOfMemoryError problem) {
            contest.entrants().forEach(bot -> streams.out().println(-1));
            throw problem;
        }
    }

    /** Says on the standard error why bots failed, with what their stderr says; not of those that cannot be started. */
    static void tell(Streams streams, Contest contest, List<Failure> failures, IntFunction<String> names) {
        failures.stream().filter(each -> contest.entrants().get(each.player()).problem() == null).forEach(failure -> {
            streams.warn(names.apply(failure.player()) + " has failed in turn " + failure.turn() + ": "
                + failure.reason());
            FailureReason.print(streams.err(), failure, "  ");
        });
    }

    /**
     * Says which attempts do not count, and why.
     *
     * @throws FailedException if none counts
     */
    static void tell(Streams streams, CountedGame<?> game) {
        game.again().forEach(streams::warn);
        if (game.discarded() != null) {
            throw new FailedException(game.discarded());
        }
    }

    /** Called as soon as the match has its result, even if a file cannot be written afterwards. */
    private void printScores(MatchResult result, String seed) {
        for (int score : GameResultScores.of(result)) {
            streams.out().println(score);
        }
        if (seed != null) {
            streams.out().println(seed);
        }
    }

    private static Path temporary() {
        try {
            return Files.createTempFile("steward-", RefereeFiles.REPLAY);
        } catch (IOException problem) {
            throw new InputException("-s: cannot make a file for the replay (-r names one): " + problem.getMessage());
        }
    }

    private Path makePage(Path recording) {
        Path file = RefereeFiles.pageOf(recording);
        try (OutputStream html = new BufferedOutputStream(OutputFiles.open(file, true))) {
            html.write(Pages.of(recording, String.join(" - ",
                contest.entrants().stream().map(Contest.Entrant::name).toList())));
        } catch (IOException problem) {
            throw new FailedException(file + ": cannot be written: " + problem.getMessage());
        }
        return file;
    }
}
