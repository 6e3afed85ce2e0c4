package steward.game.podrace.simulator;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * Plays a {@link PodRaceBatch} with several threads. Each takes some games at a time until there are none left, the
 * caller's thread too, so that one that comes late holds nobody up. Games know nothing of each other, so that the
 * results do not depend on the number of threads. Allocates nothing in a turn. Not thread-safe: one caller at a time,
 * who leaves the batch and the commands alone meanwhile.
 *
 * <p>Threads that have nothing to do look out for the next turn before they sleep, for some tens of microseconds,
 * unless there are more of them than processors. A batch of 16 games or fewer is left to the caller's thread.
 */
public final class ParallelBatch implements AutoCloseable {

    private static final int MOST_THREADS = 1024;
    /** How many games a thread takes at a time. */
    private static final int CHUNK = 16;
    /** How often a thread looks before it sleeps. */
    private static final int PATIENCE = 2000;

    private final PodRaceBatch batch;
    private final Helper[] helpers;
    private final PodTurn kernel;
    private final int chunks;
    private final int patience;

    /** The games that nobody has taken yet begin with this chunk; so many chunks have not been played. */
    private final AtomicInteger next;
    private final AtomicInteger left = new AtomicInteger();
    private volatile long turn;
    /** Written before {@link #next} says that there is something to take. */
    private volatile PodRaceBatch.Commands commands;
    private volatile Throwable problem;
    private volatile boolean closed;
    /** The caller, when it sleeps. */
    private volatile Thread sleeper;

    /**
     * Starts the threads.
     *
     * @param threads 1..1024; no more are used than there are sixteens of games
     * @throws IllegalArgumentException if that is not so
     */
    public ParallelBatch(PodRaceBatch batch, int threads) {
        if (threads < 1 || threads > MOST_THREADS) {
            throw new IllegalArgumentException(threads + " threads, expected 1.." + MOST_THREADS);
        }
        this.batch = batch;
        kernel = batch.kernel();
        chunks = (batch.games() - 1) / CHUNK + 1;
        next = new AtomicInteger(chunks);
        helpers = new Helper[Math.min(threads, chunks) - 1];
        patience = threads() <= Runtime.getRuntime().availableProcessors() ? PATIENCE : 0;
        for (int k = 0; k < helpers.length; k++) {
            helpers[k] = new Helper(batch.kernel());
            helpers[k].setName("pod-race-batch-" + (k + 1));
            helpers[k].setDaemon(true);
            helpers[k].start();
        }
    }

    /** How many threads play, the caller's among them. */
    public int threads() {
        return helpers.length + 1;
    }

    /**
     * Plays a turn of every game; returns when all are played, also when the thread is interrupted meanwhile (it stays
     * interrupted).
     *
     * @throws IllegalArgumentException if the commands are for another number of games
     * @throws IllegalStateException    if the threads have been let go
     */
    public void play(PodRaceBatch.Commands given) {
        batch.check(given);
        if (closed) {
            throw new IllegalStateException("the threads have been let go");
        }
        problem = null;
        commands = given;
        left.set(chunks);
        next.set(0);
        turn++;                                        // one caller at a time: nobody else writes it
        wake();
        playChunks(kernel);
        await();
        if (problem != null) {
            throw new IllegalStateException(problem);
        }
    }

    private void wake() {
        for (Helper helper : helpers) {
            if (helper.asleep) {
                LockSupport.unpark(helper);
            }
        }
    }

    /** Takes games and plays them until there are none left. */
    private void playChunks(PodTurn by) {
        for (int chunk = next.getAndIncrement(); chunk < chunks; chunk = next.getAndIncrement()) {
            try {
                int first = chunk * CHUNK;
                batch.play(commands, by, first, Math.min(first + CHUNK, batch.games()));
            } catch (RuntimeException | Error thrown) {
                problem = thrown;
            }
            if (left.decrementAndGet() == 0) {
                LockSupport.unpark(sleeper);
            }
        }
    }

    private void await() {
        for (int look = 0; look < patience && left.get() > 0; look++) {
            Thread.onSpinWait();
        }
        boolean interrupted = false;
        sleeper = Thread.currentThread();
        while (left.get() > 0) {
            LockSupport.park(this);
            interrupted |= Thread.interrupted();
        }
        sleeper = null;
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Plays along. */
    private final class Helper extends Thread {

        private final PodTurn own;
        /** Whoever starts a turn after this was set wakes it. */
        private volatile boolean asleep;

        Helper(PodTurn own) {
            this.own = own;
        }

        @Override
        public void run() {
            for (long played = 0; !closed;) {
                long current = turn;
                if (current == played) {
                    awaitTurn(played);
                } else {
                    playChunks(own);
                    played = current;
                }
            }
        }

        private void awaitTurn(long played) {
            for (int look = 0; look < patience; look++) {
                if (turn != played || closed) {
                    return;
                }
                Thread.onSpinWait();
            }
            asleep = true;
            while (turn == played && !closed) {
                LockSupport.park(this);
                Thread.interrupted();                  // nobody means it
            }
            asleep = false;
        }
    }

    /** Lets the threads go. */
    @Override
    public void close() {
        closed = true;
        for (Helper helper : helpers) {
            LockSupport.unpark(helper);
        }
    }
}
