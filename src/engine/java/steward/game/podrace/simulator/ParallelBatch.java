package steward.game.podrace.simulator;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * Plays a {@link PodRaceBatch} with several threads. Each thread, including the caller's, takes some games at a time
 * until none are left, so that a late thread delays no other. Games are independent of each other, so the results do
 * not depend on the number of threads. Allocates nothing in a turn. Not thread-safe: one caller at a time, which must
 * not change the batch or the commands during the call.
 *
 * <p>Idle threads spin for some tens of microseconds before they sleep, unless there are more threads than processors.
 * A batch of 16 games or fewer is left to the caller's thread.
 */
public final class ParallelBatch implements AutoCloseable {

    private static final int MOST_THREADS = 1024;
    /** How many games a thread takes at a time. */
    private static final int CHUNK = 16;
    /** How often a thread checks before it sleeps. */
    private static final int SPIN_LIMIT = 2000;

    private final PodRaceBatch batch;
    private final Helper[] helpers;
    private final PodTurn kernel;
    private final int chunks;
    private final int spinLimit;

    /** The first chunk of games that no thread has taken; and the number of chunks that are not finished. */
    private final AtomicInteger next;
    private final AtomicInteger left = new AtomicInteger();
    private volatile long turn;
    /** Written before {@link #next} makes chunks available. */
    private volatile PodRaceBatch.Commands commands;
    private volatile Throwable problem;
    private volatile boolean closed;
    /** The caller's thread while it may sleep. */
    private volatile Thread parkedCaller;

    /**
     * Starts the threads.
     *
     * @param threads 1..1024; at most one per 16 games is used
     * @throws IllegalArgumentException if the number is out of range
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
        spinLimit = threads() <= Runtime.getRuntime().availableProcessors() ? SPIN_LIMIT : 0;
        for (int k = 0; k < helpers.length; k++) {
            helpers[k] = new Helper(batch.kernel());
            helpers[k].setName("pod-race-batch-" + (k + 1));
            helpers[k].setDaemon(true);
            helpers[k].start();
        }
    }

    /** The number of threads, including the caller's. */
    public int threads() {
        return helpers.length + 1;
    }

    /**
     * Plays a turn of every game; returns when all are played. If the thread is interrupted meanwhile, it stays
     * interrupted.
     *
     * @throws IllegalArgumentException if the commands are for another number of games
     * @throws IllegalStateException    if the batch is closed
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
        turn++;                                        // one caller at a time: no other thread writes it
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

    /** Takes chunks and plays them until none are left. */
    private void playChunks(PodTurn by) {
        for (int chunk = next.getAndIncrement(); chunk < chunks; chunk = next.getAndIncrement()) {
            try {
                int first = chunk * CHUNK;
                batch.play(commands, by, first, Math.min(first + CHUNK, batch.games()));
            } catch (RuntimeException | Error thrown) {
                problem = thrown;
            }
            if (left.decrementAndGet() == 0) {
                LockSupport.unpark(parkedCaller);
            }
        }
    }

    private void await() {
        for (int look = 0; look < spinLimit && left.get() > 0; look++) {
            Thread.onSpinWait();
        }
        boolean interrupted = false;
        parkedCaller = Thread.currentThread();
        while (left.get() > 0) {
            LockSupport.park(this);
            interrupted |= Thread.interrupted();
        }
        parkedCaller = null;
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** A worker thread. */
    private final class Helper extends Thread {

        private final PodTurn own;
        /** Set before sleeping; a caller that starts a turn after that wakes the thread. */
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
            for (int look = 0; look < spinLimit; look++) {
                if (turn != played || closed) {
                    return;
                }
                Thread.onSpinWait();
            }
            asleep = true;
            while (turn == played && !closed) {
                LockSupport.park(this);
                Thread.interrupted();                  // clears an interrupt, which has no meaning here
            }
            asleep = false;
        }
    }

    /** Ends the threads. */
    @Override
    public void close() {
        closed = true;
        for (Helper helper : helpers) {
            LockSupport.unpark(helper);
        }
    }
}
