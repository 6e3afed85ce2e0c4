package steward.league.store;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import steward.files.InputException;
import steward.league.StoredGame;

/**
 * Stores games in the order in which they end, on a thread of its own. Games that end while a transaction is under way
 * share the next one: at a few games a second each has its own, at thousands many go together.
 */
public final class GameWriter implements AutoCloseable {

    /** Games that may wait; who brings more waits too. */
    private static final int MOST_WAITING = 4096;
    private static final long POLL_MS = 100;

    private final GameStore store;
    private final int season;
    private final BlockingQueue<List<StoredGame>> waiting = new ArrayBlockingQueue<>(MOST_WAITING);
    private final Thread thread = new Thread(this::run, "league writer");
    private volatile boolean closing;
    private volatile InputException problem;
    private long stored;
    private long transactions;

    /** A writer into a season, whose thread is not running yet. */
    public GameWriter(GameStore store, int season) {
        this.store = store;
        this.season = season;
        thread.setDaemon(true);
    }

    /** Starts the thread, once. */
    public void start() {
        thread.start();
    }

    /**
     * Hands over games that belong together: they are stored in one transaction.
     *
     * @return whether they will be: {@code false} after a problem
     */
    public boolean add(List<StoredGame> games) throws InterruptedException {
        while (problem == null) {
            if (waiting.offer(games, POLL_MS, TimeUnit.MILLISECONDS)) {
                return true;
            }
        }
        return false;
    }

    private void run() {
        List<List<StoredGame>> batch = new ArrayList<>();
        while (problem == null) {
            try {
                List<StoredGame> first = waiting.poll(POLL_MS, TimeUnit.MILLISECONDS);
                if (first == null) {
                    if (closing && waiting.isEmpty()) {
                        return;
                    }
                    continue;
                }
                batch.add(first);
                waiting.drainTo(batch);
                List<StoredGame> games = batch.stream().flatMap(List::stream).toList();
                if (!games.isEmpty()) {
                    store.add(season, games);
                    count(games.size());
                }
                batch.clear();
            } catch (InputException failed) {
                problem = failed;
            } catch (RuntimeException unexpected) {
                problem = new InputException("a game could not be stored: " + unexpected);
            } catch (InterruptedException interrupted) {
                closing = true;
            }
        }
    }

    private synchronized void count(int games) {
        stored += games;
        transactions++;
    }

    /** Returns how many games have been stored. */
    public synchronized long stored() {
        return stored;
    }

    /** In how many transactions. */
    public synchronized long transactions() {
        return transactions;
    }

    /** Returns why no more can be stored, or {@code null}. */
    public InputException problem() {
        return problem;
    }

    /** Stores what waits. */
    @Override
    public void close() {
        closing = true;
        waiting.offer(List.of());                      // wakes the thread; if there is no room it is awake
        boolean interrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException again) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
