package steward.league.store;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import steward.files.InputException;
import steward.league.Decision;
import steward.league.StoredGame;

/**
 * Writer of decisions and games in the order in which they arrive, on a thread of its own. Whatever arrives during a
 * transaction shares the next one: at a few games a second each game has its own, at thousands many share one.
 */
public final class GameWriter implements AutoCloseable {

    /** Games that may wait; who brings more waits too. */
    private static final int MOST_WAITING = 4096;
    private static final long POLL_MS = 100;

    private final GameStore store;
    private final int season;
    private final BlockingQueue<Item> waiting = new ArrayBlockingQueue<>(MOST_WAITING);
    private final Thread thread = new Thread(this::run, "league writer");
    private volatile boolean closing;
    private volatile InputException problem;
    private volatile int decided;
    private final AtomicLong stored = new AtomicLong();
    private final AtomicLong transactions = new AtomicLong();

    /** News of the schedule and games, stored in one transaction. */
    private record Item(Decision.News news, List<StoredGame> games) { }

    /**
     * A writer into a season, whose thread is not running yet.
     *
     * @param decided number of the first decision that is not stored
     */
    public GameWriter(GameStore store, int season, int decided) {
        this.store = store;
        this.season = season;
        this.decided = decided;
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
        return add(new Item(Decision.News.NONE, games));
    }

    /** Hands over news of the schedule, which are stored before all games that are handed over later. */
    public void add(Decision.News news) throws InterruptedException {
        if (!news.isEmpty()) {
            add(new Item(news, List.of()));
        }
    }

    /** True if a decision is stored. */
    public boolean isDecided(int number) {
        return number < decided;
    }

    private boolean add(Item item) throws InterruptedException {
        while (problem == null) {
            if (waiting.offer(item, POLL_MS, TimeUnit.MILLISECONDS)) {
                return true;
            }
        }
        return false;
    }

    private void run() {
        List<Item> batch = new ArrayList<>();
        try {
            while (!closing || !waiting.isEmpty()) {
                Item first = waiting.poll(POLL_MS, TimeUnit.MILLISECONDS);
                if (first != null) {
                    batch.add(first);
                    waiting.drainTo(batch);
                    store(batch);
                    batch.clear();
                }
            }
        } catch (InputException failed) {
            problem = failed;
        } catch (RuntimeException | InterruptedException unexpected) {
            problem = new InputException("a game could not be stored: " + unexpected);
        }
    }

    private void store(List<Item> batch) {
        List<Decision.News> news = batch.stream().map(Item::news).filter(each -> !each.isEmpty()).toList();
        List<StoredGame> games = batch.stream().flatMap(item -> item.games().stream()).toList();
        if (news.isEmpty() && games.isEmpty()) {
            return;
        }
        store.add(season, news, games);
        for (Decision.News each : news) {
            decided = each.made().isEmpty() ? decided : each.made().get(each.made().size() - 1).number() + 1;
        }
        stored.addAndGet(games.size());
        transactions.incrementAndGet();
    }

    /** Returns how many games have been stored. */
    public long stored() {
        return stored.get();
    }

    /** Returns the number of transactions. */
    public long transactions() {
        return transactions.get();
    }

    /** Returns why no more can be stored, or {@code null}. */
    public InputException problem() {
        return problem;
    }

    /** Stores what waits. */
    @Override
    public void close() {
        closing = true;
        waiting.offer(new Item(Decision.News.NONE, List.of()));    // wakes the thread; if there is no room it is awake
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
