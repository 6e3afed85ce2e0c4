package steward.contest;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import steward.Internal;
import steward.files.InputException;
import steward.match.MatchListener;
import steward.match.MatchResult;

/**
 * Play of a series' games, several at the same time. A failure is reported with its game and does not end other games.
 * There is one exception: if a replay cannot be written (on a full disk, say), no further games are begun, and those
 * under way are played to their end.
 *
 * <p>A game that was lost on time because others used the processors is played again at once (see {@link Attempts}).
 */
public final class SeriesPlay {

    /** Play of one match, as {@link Contest#play} does it. */
    public interface MatchPlay {

        /** See {@link Contest#play}; in some attempts at a game bots are held, see {@link Attempts}. */
        MatchResult play(Contest contest, long seed, int rotation, OutputStream recording, MatchListener follower)
            throws InterruptedException;
    }

    /** A game during which a file was touched: it is played anew, or the series is over. */
    private static final Series.Played DISCARDED = new Series.Played(0, 0, 0, null, null, List.of(), null);

    private final Series series;
    private final MatchPlay match;
    private final boolean overwrite;
    private final Standings standings;
    private final ProgramWatch watch;
    private boolean leads;

    /** Guarded by this, as is all below: games that are under way. */
    private final Set<Game> underWay = new LinkedHashSet<>();
    private int begun;
    /** Numbers of games that were begun and do not count, since a file was touched meanwhile. */
    private final Deque<Integer> again = new ArrayDeque<>();
    private boolean brokenOff;
    private String stopped;

    /** @param overwrite whether replays that exist are replaced */
    public SeriesPlay(Series series, boolean overwrite) {
        this(series, overwrite, Contest::play);
    }

    /** @param match plays its matches */
    public SeriesPlay(Series series, boolean overwrite, MatchPlay match) {
        this(series, overwrite, match, ProgramWatch.of(series.contest(), waiting -> { }));
    }

    /** @param watch over its programs: when one becomes another, no further game is begun */
    @Internal
    public SeriesPlay(Series series, boolean overwrite, ProgramWatch watch) {
        this(series, overwrite, Contest::play, watch);
    }

    private SeriesPlay(Series series, boolean overwrite, MatchPlay match, ProgramWatch watch) {
        this.series = series;
        this.match = match;
        this.overwrite = overwrite;
        this.watch = watch;
        standings = new Standings(series.contest());
    }

    /**
     * A game under way.
     *
     * @param attempts at it so far
     * @param file    its replay, or {@code null}
     * @param refused why its replay cannot be opened, or {@code null}
     * @param before  the same game as it was played before, which this one is to replace, or {@code null}
     * @param mark    of the programs when it began
     */
    private record Game(int number, long seed, int rotation, Attempts attempts, GameLog log, ReplayFile file,
                        String refused, Series.Played before, String mark) { }

    public Series series() {
        return series;
    }

    /** Notes in each game who leads; to be called before {@link #play}. */
    @Internal
    public void followLeads() {
        leads = true;
    }

    /** The games that are over. */
    public Standings standings() {
        return standings;
    }

    /**
     * Plays all games. Call once.
     *
     * @param each called after each game, by any thread
     */
    public void play(int threads, Runnable each) throws InterruptedException {
        play(threads, game -> each.run());
    }

    /** Plays all games; the consumer is told each game, by any thread. */
    @Internal
    public void play(int threads, Consumer<Series.Played> each) throws InterruptedException {
        int used = Math.min(threads, series.games());
        WorkerThreads.run("series", used, thread -> () -> {
            for (Series.Played game = playNext(); game != null; game = playNext()) {
                if (game != DISCARDED) {
                    each.accept(game);
                }
            }
            return null;
        });
    }

    /** Plays a game; {@code null} if there is none any more, or it does not count. */
    private Series.Played playNext() throws InterruptedException {
        Game game = watch.await(this::isOver) ? begin() : null;
        while (game != null) {
            MatchResult result = null;
            String problem = game.refused();
            if (problem == null) {
                try {
                    result = match.play(game.attempts().contest(), game.seed(), game.rotation(), game.file(),
                        game.log());
                } catch (UncheckedIOException failed) {
                    problem = failed.getMessage();
                } catch (InterruptedException interrupted) {
                    close(game);
                    cut(game);
                    throw interrupted;
                }
            }
            close(game);
            synchronized (this) {
                if (brokenOff) {
                    return null;
                }
                underWay.remove(game);
                if (!watch.isSince(game.mark())) {
                    discard(game);
                    again.add(game.number());
                    return DISCARDED;
                }
                Series.Played played = played(game, result, problem);
                boolean again = played.result() != null && game.attempts().demandAnother(played.failures());
                Game another = again && stopped == null ? again(game, played) : null;
                List<Failure> found = game.log().failures();
                if (game.attempts().discarded() != null) {
                    played = played.without(game.attempts().discarded());
                    found = List.of();
                }
                if (another == null) {
                    standings.add(played, found, game.log().times());
                    return played;
                }
                game = another;
            }
        }
        return null;
    }

    private synchronized boolean isOver() {
        return brokenOff || stopped != null || begun == series.games() && again.isEmpty();
    }

    /** The next game, its replay open; {@code null} if there is none any more. */
    private synchronized Game begin() {
        if (isOver()) {
            return null;
        }
        int number = again.isEmpty() ? ++begun : again.remove();
        return begin(number, new Attempts(series.contest(), series.hiccups(), series.rotation(number)), null);
    }

    private Game begin(int number, Attempts attempts, Series.Played before) {
        ReplayFile file = null;
        String refused = null;
        try {
            file = series.file(number) == null ? null : new ReplayFile(series.file(number), overwrite);
        } catch (InputException problem) {
            refused = problem.getMessage();
        }
        int rotation = series.rotation(number);
        GameLog log = new GameLog(series.contest(), rotation);
        if (leads) {
            log.followLeads();
        }
        Game game = new Game(number, series.seed(number), rotation, attempts, log, file, refused, before,
            watch.mark());
        underWay.add(game);
        return game;
    }

    /** Begins the game once more; the replay of the first, if it is kept, makes room. {@code null} if it cannot. */
    private Game again(Game game, Series.Played played) {
        try {
            Path kept = series.starvedFile(game.number(), game.attempts().played());
            boolean moved = played.replay() != null && game.file().moveTo(kept);
            return begin(game.number(), game.attempts(), played.keptAs(moved ? kept : null));
        } catch (IOException problem) {
            stopped = played.replay() + ": cannot be renamed: " + problem.getMessage();
            return null;
        }
    }

    /** Removes what is left of a game that does not count, and of the attempts before it. */
    private static void discard(Game game) {
        if (game.file() != null) {
            game.file().remove();
        }
        for (Series.Played each = game.before(); each != null; each = each.starved()) {
            if (each.replay() != null) {
                each.replay().toFile().delete();
            }
        }
    }

    private static void close(Game game) {
        if (game.file() != null) {
            game.file().close();
        }
    }

    /** A game that is over; its replay is kept or removed. */
    private Series.Played played(Game game, MatchResult found, String failed) {
        ReplayFile file = game.file();
        boolean broken = file != null && file.isBroken();
        Series.Played played = new Series.Played(game.number(), game.seed(), game.rotation(), broken ? null : found,
            failed, game.log().failures().stream().map(Failure::brief).toList(), file == null ? null : file.path(),
            game.log().facts(), game.before());
        if (file != null && played.result() == null) {
            file.removeIfEmpty();
        }
        if (file != null && !series.keep().keeps(series.contest(), played)) {
            file.remove();
        }
        if (broken) {
            played = played.without(file.problem());
            stopped = stopped == null ? played.failure() : stopped;
        }
        return file == null || file.exists() ? played : played.keptAs(null);
    }

    /**
     * Breaks the series off, from any thread: what is under way does not count, and its replays are removed, but for
     * those with a turn if all are kept.
     *
     * @return the replays of unfinished games that are kept
     */
    public synchronized List<Path> breakOff() {
        brokenOff = true;
        List<Path> kept = new ArrayList<>();
        for (Game game : underWay) {
            if (!cut(game)) {
                kept.add(game.file().path());
            }
        }
        return kept;
    }

    /** Ends a game that has been broken off; returns whether nothing is left of it. */
    private boolean cut(Game game) {
        if (game.file() == null) {
            return true;
        }
        if (series.keep() == KeptReplays.ALL && game.log().turns() > 0) {
            return false;
        }
        game.file().remove();
        return true;
    }

    /** True if {@link #breakOff} has been called. */
    public synchronized boolean isBrokenOff() {
        return brokenOff;
    }

    /** Returns the file that ended the series, since by it a program became another one; or {@code null}. */
    @Internal
    public String changed() {
        return watch.changed();
    }

    /** Returns why the series ended before its last game, or {@code null}. */
    public synchronized String stopped() {
        return stopped;
    }
}
