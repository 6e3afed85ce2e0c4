package steward.live;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Count of a match's viewers: how many may follow at the same time, and how much they still have to receive.
 * Thread-safe.
 */
final class Viewers {

    private final int most;
    private int following;
    private int come;
    private int served;
    private int copies;

    /** @param most how many viewers may follow at the same time */
    Viewers(int most) {
        this.most = most;
    }

    int most() {
        return most;
    }

    synchronized int following() {
        return following;
    }

    /** Adds a viewer; false if there are too many already. */
    synchronized boolean enter() {
        if (following == most) {
            return false;
        }
        following++;
        come++;
        notifyAll();
        return true;
    }

    /** @param all whether the viewer got every line to the last; otherwise it disconnected before */
    synchronized void leave(boolean all) {
        following--;
        served += all ? 1 : 0;
        notifyAll();
    }

    /** A copy of the whole match was sent. */
    synchronized void copied() {
        copies++;
        notifyAll();
    }

    /** Waits for the first viewer; returns whether there was one. */
    synchronized boolean awaitFirst(long mostMs) throws InterruptedException {
        return await(() -> come > 0, mostMs);
    }

    /** Waits until there are no viewers any more; returns whether that is so. */
    synchronized boolean awaitServed(long mostMs) throws InterruptedException {
        return await(() -> following == 0, mostMs);
    }

    /** Waits until there were as many copies as viewers who saw the end. */
    synchronized boolean awaitCopies(long mostMs) throws InterruptedException {
        return await(() -> copies >= served, mostMs);
    }

    private boolean await(BooleanSupplier condition, long mostMs) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(mostMs);
        while (!condition.getAsBoolean()) {
            long leftMs = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            if (leftMs <= 0) {
                return false;
            }
            wait(leftMs);
        }
        return true;
    }
}
