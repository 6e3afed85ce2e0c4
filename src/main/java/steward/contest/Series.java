package steward.contest;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.replay.WriteBehind;

/**
 * Many games between the same bots. Game k, counted from 0, has the seed {@code first + k}; with {@code swap} each seed
 * is played once for every way to move the bots up, one after the other.
 *
 * @param contest what is played
 * @param first   seed of the first game
 * @param seeds   how many seeds
 * @param swap    whether the bots change sides
 * @param folder  for the replays, or {@code null}
 */
public record Series(Contest contest, long first, int seeds, boolean swap, Path folder) {

    private static final MatchListener NOBODY = new MatchListener() { };
    private static final int LEAST_DIGITS = 4;

    /**
     * A game of the series.
     *
     * @param number   counted from 1
     * @param seed     its seed
     * @param rotation by how many places the bots had moved up
     * @param result   or {@code null} if it could not be brought to one
     * @param failure  why it could not, or {@code null}
     */
    public record Played(int number, long seed, int rotation, MatchResult result, String failure) {
    }

    /** How many games there are in all. */
    public int games() {
        return seeds * sides();
    }

    private int sides() {
        return swap ? contest.entrants().size() : 1;
    }

    /** The replay of a game, counted from 1; or {@code null}. */
    public Path file(int number) {
        if (folder == null) {
            return null;
        }
        String digits = Integer.toString(number);
        int width = Math.max(LEAST_DIGITS, Integer.toString(games()).length());
        return folder.resolve("game-" + "0".repeat(width - digits.length()) + digits + ".jsonl");
    }

    /** Checks that all replays can be written. */
    public void prepare(boolean overwrite) {
        if (folder == null) {
            return;
        }
        OutputFiles.prepareFolder(folder);
        for (int number = 1; number <= games() && !overwrite; number++) {
            if (Files.exists(file(number))) {
                throw OutputFiles.exists(file(number));
            }
        }
    }

    /**
     * Plays all games, several at the same time. What fails in one game is told in it and ends no other.
     *
     * @param each called after each game, by any thread
     * @return in the order of their numbers
     */
    public List<Played> play(int threads, boolean overwrite, Runnable each) throws InterruptedException {
        ExecutorService workers = Executors.newFixedThreadPool(Math.min(threads, games()), Series::daemon);
        try {
            List<Future<Played>> coming = new ArrayList<>();
            for (int number = 1; number <= games(); number++) {
                int game = number;
                coming.add(workers.submit(() -> {
                    Played played = play(game, overwrite);
                    each.run();
                    return played;
                }));
            }
            List<Played> games = new ArrayList<>();
            for (Future<Played> one : coming) {
                games.add(one.get());
            }
            return games;
        } catch (ExecutionException problem) {
            throw new IllegalStateException("a game of the series", problem.getCause());
        } finally {
            workers.shutdownNow();
        }
    }

    private static Thread daemon(Runnable work) {
        Thread thread = new Thread(work, "series");
        thread.setDaemon(true);
        return thread;
    }

    private Played play(int number, boolean overwrite) throws InterruptedException {
        int sides = sides();
        long seed = first + (number - 1) / sides;
        int rotation = (number - 1) % sides;
        Path file = file(number);
        try (OutputStream recording = file == null ? null : new WriteBehind(OutputFiles.open(file, overwrite))) {
            return new Played(number, seed, rotation, contest.play(seed, rotation, recording, NOBODY), null);
        } catch (InputException | UncheckedIOException | IOException problem) {
            return new Played(number, seed, rotation, null, problem.getMessage());
        }
    }
}
