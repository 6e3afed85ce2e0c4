package steward.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import steward.match.MatchListener;
import steward.match.MatchResult;

/**
 * Plays one match and tells how it went.
 *
 * @param report how much is said
 * @param strict whether a bot that fails makes the exit status 1
 */
record OneGame(Streams streams, Contest contest, Report report, boolean strict) {

    private static final MatchListener NOBODY = new MatchListener() { };

    /**
     * @param file for the replay, or {@code null}
     * @return the exit status
     */
    int play(long seed, Path file, boolean overwrite) throws InterruptedException {
        MatchResult result;
        try (OutputStream recording = file == null ? null : OutputFiles.open(file, overwrite);
             Interruption hint = new Interruption(streams, file)) {
            result = contest.play(seed, 0, recording, follower(seed));
            hint.over();
        } catch (UncheckedIOException problem) {
            throw new FailedException("the match could not be brought to a result: " + problem.getMessage());
        } catch (IOException problem) {
            throw new FailedException(file + ": cannot be closed: " + problem.getMessage());
        }
        switch (report) {
            case JSON -> MatchJson.print(streams, contest, seed, result, file);
            case LINE -> streams.out().println(MatchText.headline(contest.sceneName(), seed, result));
            default -> {
                MatchText.print(streams.out(), contest.sceneName(), seed, result);
                if (file != null) {
                    MatchText.printReplay(streams.out(), file);
                }
            }
        }
        return strict && result.anyFault() ? ExitStatus.FAILED : ExitStatus.DONE;
    }

    private MatchListener follower(long seed) {
        if (report != Report.FULL || !streams.outTerminal()) {
            return NOBODY;
        }
        List<String> names = contest.entrants().stream().map(Contest.Entrant::name).toList();
        streams.out().println(contest.sceneName() + ", seed " + seed + ": "
            + Words.plain(String.join(" against ", names)));
        streams.out().flush();
        return new Watcher(streams, names);
    }
}
