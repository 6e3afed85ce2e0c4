package steward.machines.serve;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Pauses of workers that cannot play: a second after the first failure, twice as long after each further one. When a
 * pause is over, one job is the worker's test; it plays on if that is believed. Thread-safe.
 */
final class WorkerPauses {

    private static final long FIRST_NANOS = TimeUnit.SECONDS.toNanos(1);
    private static final long LONGEST_NANOS = TimeUnit.MINUTES.toNanos(10);

    private final LongSupplier clock;
    private final Map<String, Pause> pauses = new HashMap<>();

    private static final class Pause {
        private long length;
        private long began;
        private boolean tested;
    }

    /** @param clock as {@link System#nanoTime} */
    WorkerPauses(LongSupplier clock) {
        this.clock = clock;
    }

    /**
     * Begins a pause, or a longer one if the test has failed; failures of games that were under way change nothing.
     *
     * @return true if the worker was not paused before
     */
    synchronized boolean failed(String worker) {
        Pause pause = pauses.get(worker);
        boolean isNew = pause == null;
        if (isNew) {
            pause = new Pause();
            pauses.put(worker, pause);
        }
        if (isNew || isDue(pause)) {
            pause.length = isNew ? FIRST_NANOS : Math.min(LONGEST_NANOS, 2 * pause.length);
            pause.began = clock.getAsLong();
            pause.tested = false;
        }
        return isNew;
    }

    /** Ends a pause. @return true if there was one */
    synchronized boolean played(String worker) {
        return pauses.remove(worker) != null;
    }

    /** Returns how many jobs a worker may have at the same time, of so many without a pause. */
    synchronized int places(String worker, int usual) {
        Pause pause = pauses.get(worker);
        return pause == null ? usual : isDue(pause) ? Math.min(1, usual) : 0;
    }

    /** True if a job may be handed to a worker: it is not paused, or is to be tested. */
    synchronized boolean mayTake(String worker) {
        Pause pause = pauses.get(worker);
        return pause == null || isDue(pause) && !pause.tested;
    }

    /** Notes that a worker has joined anew: a test that it was given before is void. */
    synchronized void joined(String worker) {
        Pause pause = pauses.get(worker);
        if (pause != null) {
            pause.tested = false;
        }
    }

    /** Notes that a worker has been handed a job. */
    synchronized void took(String worker) {
        Pause pause = pauses.get(worker);
        if (pause != null) {
            pause.tested = true;
        }
    }

    private boolean isDue(Pause pause) {
        return clock.getAsLong() - pause.began >= pause.length;
    }
}
