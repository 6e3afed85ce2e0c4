package steward.game.podrace;

/**
 * Plays a {@link PodRaceBatch} with several threads, each a range of the games. Games know nothing of each other, so
 * that the results do not depend on the number of threads. The caller's thread plays the first range. Allocates nothing
 * in a turn. Not thread-safe: one caller at a time, who leaves the batch and the commands alone meanwhile.
 *
 * <p>Waking the threads takes some microseconds a turn: it pays from some hundred games on.
 */
public final class ParallelBatch implements AutoCloseable {

    private static final int MOST_THREADS = 1024;

    private final PodRaceBatch batch;
    private final PodTurn[] kernels;
    private final Object gate = new Object();
    private final Object end = new Object();

    /** Which turn is to be played, of which commands; after the last there is none. Guarded by {@link #gate}. */
    private long turn;
    private PodRaceBatch.Commands commands;
    private boolean closed;
    /** How many threads still play, and what went wrong. Guarded by {@link #end}. */
    private int playing;
    private Throwable problem;

    /**
     * Starts the threads.
     *
     * @param threads 1..1024; no more than there are games are used
     * @throws IllegalArgumentException if that is not so
     */
    public ParallelBatch(PodRaceBatch batch, int threads) {
        if (threads < 1 || threads > MOST_THREADS) {
            throw new IllegalArgumentException(threads + " threads, expected 1.." + MOST_THREADS);
        }
        this.batch = batch;
        kernels = new PodTurn[Math.min(threads, batch.games())];
        for (int k = 0; k < kernels.length; k++) {
            kernels[k] = batch.kernel();
        }
        for (int k = 1; k < kernels.length; k++) {
            int range = k;
            Thread thread = new Thread(() -> work(range), "pod-race-batch-" + k);
            thread.setDaemon(true);
            thread.start();
        }
    }

    /** How many threads play, the caller's among them. */
    public int threads() {
        return kernels.length;
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
        synchronized (end) {
            playing = kernels.length - 1;
            problem = null;
        }
        synchronized (gate) {
            if (closed) {
                throw new IllegalStateException("the threads have been let go");
            }
            commands = given;
            turn++;
            gate.notifyAll();
        }
        try {
            playRange(0, given);
        } finally {
            await();
        }
        if (problem != null) {
            throw new IllegalStateException(problem);
        }
    }

    private void playRange(int range, PodRaceBatch.Commands given) {
        long games = batch.games();
        batch.play(given, kernels[range], (int) (games * range / kernels.length),
            (int) (games * (range + 1) / kernels.length));
    }

    private void await() {
        boolean interrupted = false;
        synchronized (end) {
            while (playing > 0) {
                try {
                    end.wait();
                } catch (InterruptedException later) {
                    interrupted = true;
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void work(int range) {
        for (long next = 1;; next++) {
            PodRaceBatch.Commands given = next(next);
            if (given == null) {
                return;
            }
            Throwable wrong = null;
            try {
                playRange(range, given);
            } catch (RuntimeException | Error thrown) {
                wrong = thrown;
            }
            synchronized (end) {
                problem = wrong == null ? problem : wrong;
                if (--playing == 0) {
                    end.notifyAll();
                }
            }
        }
    }

    /** Waits for a turn. @return its commands, {@code null} when there is none any more */
    private PodRaceBatch.Commands next(long number) {
        synchronized (gate) {
            while (turn < number && !closed) {
                try {
                    gate.wait();
                } catch (InterruptedException nobodyMeansIt) {
                    continue;
                }
            }
            return turn < number ? null : commands;
        }
    }

    /** Lets the threads go. */
    @Override
    public void close() {
        synchronized (gate) {
            closed = true;
            gate.notifyAll();
        }
    }
}
