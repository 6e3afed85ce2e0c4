package steward.contest;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.TeeListener;

/**
 * One game for a tool that rates it, played until an attempt counts (see {@link Attempts}).
 *
 * @param <T>       of the follower
 * @param result    of the last attempt
 * @param follower  which was told of that attempt
 * @param failures  of its bots
 * @param again     why each attempt before was played again, a sentence each without its full stop
 * @param discarded why the last attempt does not count either, or {@code null}
 */
public record CountedGame<T extends MatchListener>(MatchResult result, T follower, List<Failure> failures,
                                                   List<String> again, String discarded) {

    /**
     * Plays it.
     *
     * @param followers  one for each attempt
     * @param recordings where the replay of each attempt goes, closed after it; {@code null} for nowhere
     * @throws RuntimeException if it could not be brought to a result
     * @throws IOException      if a recording cannot be closed
     */
    public static <T extends MatchListener> CountedGame<T> play(Contest contest, long seed, Supplier<T> followers,
            Supplier<OutputStream> recordings) throws InterruptedException, IOException {
        return play(contest, seed, Hiccups.REPLAY, followers, recordings);
    }

    /**
     * Plays it; with {@link Hiccups#COUNT} the first attempt counts.
     *
     * @throws RuntimeException if it could not be brought to a result
     * @throws IOException      if a recording cannot be closed
     */
    public static <T extends MatchListener> CountedGame<T> play(Contest contest, long seed, Hiccups hiccups,
            Supplier<T> followers, Supplier<OutputStream> recordings) throws InterruptedException, IOException {
        return play(contest, seed, hiccups, followers, recordings, Contest::play);
    }

    /** Reasons why an attempt with these failures is played again. */
    private static List<String> reasons(Contest contest, List<Failure> failures) {
        return failures.stream().filter(failure -> failure.doubtful() || failure.burner() != null)
            .map(failure -> "played again, since " + contest.entrants().get(failure.player()).name()
                + " lost on time while others used the processors, in turn " + failure.turn() + ": "
                + failure.reason()).toList();
    }

    static <T extends MatchListener> CountedGame<T> play(Contest contest, long seed, Hiccups hiccups,
            Supplier<T> followers, Supplier<OutputStream> recordings, SeriesPlay.MatchPlay player)
            throws InterruptedException, IOException {
        Attempts attempts = new Attempts(contest, hiccups, 0);
        List<String> again = new ArrayList<>();
        while (true) {
            GameLog log = new GameLog(contest, 0);
            T follower = followers.get();
            MatchResult result;
            try (OutputStream recording = recordings.get()) {
                result = player.play(attempts.contest(), seed, 0, recording, new TeeListener(follower, log));
            }
            if (!attempts.demandAnother(log.failures())) {
                return new CountedGame<>(result, follower, log.failures(), again, attempts.discarded());
            }
            again.addAll(reasons(contest, log.failures()));
        }
    }
}
