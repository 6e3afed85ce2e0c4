package steward.machines.serve;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import steward.machines.token.KeptPauses.Pause;

/**
 * Pauses of workers that cannot play: a second after the first failure, twice as long after each further one. When a
 * pause is over, one job is the worker's test; it plays on if that is believed. Thread-safe.
 */
final class WorkerPauses {

    private static final long FIRST_MS = TimeUnit.SECONDS.toMillis(1);
    private static final long LONGEST_MS = TimeUnit.MINUTES.toMillis(10);

    private final LongSupplier clock;
    private final Consumer<Map<String, Pause>> keeper;
    private final Map<String, Pause> pauses;
    /** Workers that have been given their test. */
    private final Set<String> tested = new HashSet<>();

    /**
     * Goes on with the pauses of earlier runs.
     *
     * @param clock  milliseconds since 1970
     * @param keeper is given all pauses when they have changed
     */
    WorkerPauses(LongSupplier clock, Map<String, Pause> before, Consumer<Map<String, Pause>> keeper) {
        this.clock = clock;
        this.keeper = keeper;
        pauses = new HashMap<>(before);
    }

    /**
     * Begins a pause, or a longer one if the test has failed; failures of games that were under way change nothing.
     *
     * @return true if the worker was not paused before
     */
    boolean failed(String worker) {
        Map<String, Pause> changed;
        boolean isNew;
        synchronized (this) {
            Pause pause = pauses.get(worker);
            isNew = pause == null;
            if (!isNew && !isDue(pause)) {
                return false;
            }
            pauses.put(worker, new Pause(isNew ? FIRST_MS : Math.min(LONGEST_MS, 2 * pause.length()),
                clock.getAsLong()));
            tested.remove(worker);
            changed = Map.copyOf(pauses);
        }
        keeper.accept(changed);                        // a file; the broker's threads do not wait for it
        return isNew;
    }

    /** Ends a pause. @return true if there was one */
    boolean played(String worker) {
        Map<String, Pause> changed;
        synchronized (this) {
            if (pauses.remove(worker) == null) {
                return false;
            }
            changed = Map.copyOf(pauses);
        }
        keeper.accept(changed);
        return true;
    }

    /** Returns how many jobs a worker may have at the same time, of so many without a pause. */
    synchronized int places(String worker, int usual) {
        Pause pause = pauses.get(worker);
        return pause == null ? usual : isDue(pause) ? Math.min(1, usual) : 0;
    }

    /** True if a job may be handed to a worker: it is not paused, or is to be tested. */
    synchronized boolean mayTake(String worker) {
        Pause pause = pauses.get(worker);
        return pause == null || isDue(pause) && !tested.contains(worker);
    }

    /** Voids a test that a worker was given: it has joined anew, or the games of the test go to others. */
    synchronized void untested(String worker) {
        tested.remove(worker);
    }

    /**
     * Notes that a worker has been handed a job. One that was handed over before the pause was over is no test: its
     * failure is ignored, so that no other test would ever follow.
     */
    synchronized void took(String worker) {
        Pause pause = pauses.get(worker);
        if (pause != null && isDue(pause)) {
            tested.add(worker);
        }
    }

    /** True if a pause is over, also when the clock was set back meanwhile. */
    private boolean isDue(Pause pause) {
        long now = clock.getAsLong();
        return now - pause.began() >= pause.length() || now < pause.began();
    }
}
