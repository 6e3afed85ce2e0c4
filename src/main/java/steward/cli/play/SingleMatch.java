package steward.cli.play;

import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.MatchText;
import steward.cli.shared.Pages;
import steward.cli.shared.Verbosity;
import steward.cli.streams.Interruption;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.Failure;
import steward.contest.GameLog;
import steward.contest.ReplayFile;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.TeeListener;
import steward.replay.page.UnclosedOutputStream;
import steward.text.TextFormat;

/**
 * Plays one match and reports its result.
 *
 * @param report how much is said
 * @param strict whether a bot that fails makes the exit status 1
 * @param piped  whether the standard output is the replay; then all else is said on the standard error
 */
record SingleMatch(Streams streams, Contest contest, Verbosity report, boolean strict, boolean piped) {

    private static final MatchListener NOBODY = new MatchListener() { };

    /**
     * A match that is not shown.
     *
     * @param file for the replay, or {@code null}
     * @return the exit status
     */
    int play(long seed, Path file, boolean overwrite) throws InterruptedException {
        GameLog log = new GameLog(contest, 0);
        MatchResult result = result(seed, file, overwrite, null, log);
        tell(seed, result, log.failures(), file);
        return status(result);
    }

    /** As {@link #play(long, Path, boolean)}; the match is shown as the options say. */
    int play(long seed, Path file, boolean overwrite, DisplayOptions options) throws InterruptedException {
        PrintStream said = report == Verbosity.FULL ? text() : streams.err();
        try (MatchDisplay show = MatchDisplay.prepare(streams, said, options, Pages.title(names()), file, overwrite)) {
            GameLog log = new GameLog(contest, 0);
            MatchResult result = result(seed, file, overwrite, show, log);
            tell(seed, result, log.failures(), file);
            streams.out().flush();
            show.finish();
            return status(result);
        }
    }

    private MatchResult result(long seed, Path path, boolean overwrite, MatchDisplay show, GameLog log)
            throws InterruptedException {
        MatchResult result;
        ReplayFile recording = path == null ? null : new ReplayFile(path, overwrite);
        try (recording) {
            if (show != null) {
                show.awaitViewer();
            }
            try (Interruption hint = new Interruption(streams, recording == null ? null : () -> recording.exists()
                    ? "the turns so far are in " + path : "no turn was played")) {
                OutputStream file = piped ? new UnclosedOutputStream(streams.out()) : recording;
                OutputStream written = show == null ? file : show.with(file);
                result = contest.play(seed, 0, written, new TeeListener(log, follower(seed)));
                hint.over();
            }
        } catch (UncheckedIOException problem) {
            throw withoutResult(recording, problem.getMessage());
        }
        if (recording != null && recording.isBroken()) {
            throw withoutResult(recording, null);
        }
        return result;
    }

    private static FailedException withoutResult(ReplayFile recording, String problem) {
        if (recording != null) {
            recording.removeIfEmpty();
        }
        return new FailedException("the match could not be brought to a result: "
            + (recording != null && recording.isBroken() ? recording.problem() : problem));
    }

    private void tell(long seed, MatchResult result, List<Failure> failures, Path file) {
        switch (report) {
            case JSON -> MatchJson.print(streams, contest, seed, result, failures, file);
            case LINE -> text().println(MatchText.headline(contest.sceneName(), seed, result, failures));
            default -> {
                MatchText.print(text(), piped ? streams.errColour() : streams.outColour(), contest.sceneName(), seed,
                    result, failures);
                if (file != null) {
                    MatchText.printReplay(text(), file, contest.setup().scene().gameId());
                }
            }
        }
    }

    private PrintStream text() {
        return piped ? streams.err() : streams.out();
    }

    private int status(MatchResult result) {
        return strict && result.anyFault() ? ExitStatus.FAILED : ExitStatus.DONE;
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
