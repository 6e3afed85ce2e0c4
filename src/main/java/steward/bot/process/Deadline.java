package steward.bot.process;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Decides for one player between its answer and its deadline. The whole state is one number, so that every decision is
 * one compare-and-set:
 *
 * <pre>
 *            arm              complete
 *   idle ──────────▶ pending ──────────▶ idle        the player's thread: in time
 *                       │      claim
 *                       └──▶ EXPIRED ──▶ idle        the watchdog, then the player's thread: too late
 *                               │
 *                               └──────▶ ABANDONED   too late, and the player's thread is stuck
 * </pre>
 *
 * Pending is the positive time of the deadline, on the clock of {@link Watchdog#now}; idle is minus the time of the
 * previous deadline.
 */
final class Deadline {

    /** The player that the deadline belongs to. */
    interface Owner {

        /** The deadline has passed before the answer. Called on a new daemon thread. */
        void expired();

        /**
         * Called by the watchdog at least every {@link Watchdog#TICK} while pending. Must return at once; true means
         * that no answer can come any more, and the deadline passes now.
         */
        boolean tick(long now);
    }

    private static final long EXPIRED = Long.MIN_VALUE;
    private static final long ABANDONED = -1;
    private static final long NEW = -2;

    private final AtomicLong state = new AtomicLong(NEW);
    private final Watchdog watchdog;
    private final Owner owner;

    /** Written by the watchdog before it tries to decide. */
    private long seen;

    Deadline(Watchdog watchdog, Owner owner) {
        this.watchdog = watchdog;
        this.owner = owner;
    }

    /**
     * Makes the deadline pending.
     *
     * @param time when it passes; {@code Long.MAX_VALUE} is never
     */
    void arm(long time) {
        state.set(time);
        watchdog.look(time);
    }

    /** Moves a pending deadline to a later time; false if it has already passed. */
    boolean postpone(long time, long later) {
        return state.compareAndSet(time, later);
    }

    /** The answer is complete; false if the deadline has already passed, and then {@link #claim} decides. */
    boolean complete(long time) {
        return state.compareAndSet(time, -time);
    }

    /** After the deadline has passed: true if the player's thread goes on, false if it was abandoned. */
    boolean claim() {
        return state.compareAndSet(EXPIRED, NEW);
    }

    /** After the deadline has passed: true if the player's thread is abandoned, false if it went on before. */
    boolean abandon() {
        return state.compareAndSet(EXPIRED, ABANDONED);
    }

    boolean isExpired() {
        return state.get() == EXPIRED;
    }

    /** When the watchdog noticed that the deadline had passed. */
    long passedAt() {
        return seen;
    }

    /** Called only by the watchdog: decides about a pending deadline. */
    void check(long now) {
        long time = state.get();
        if (time < 0) {
            return;
        }
        seen = now;
        boolean hopeless = owner.tick(now);
        if (time > now && !hopeless || !state.compareAndSet(time, EXPIRED)) {
            return;
        }
        Thread thread = new Thread(owner::expired, "steward-deadline");
        thread.setDaemon(true);
        try {
            thread.start();
        } catch (OutOfMemoryError e) {
            // No more threads: run it here, even if that delays the other deadlines.
            owner.expired();
        }
    }

    /**
     * Called only by the watchdog: when to check again. Between two turns that is the previous turn's deadline: the
     * next one is later, so a player that answers at once does not wake the watchdog.
     */
    long nextLook(long now) {
        long time = state.get();
        boolean passed = time == EXPIRED || Math.abs(time) <= now && time < 0;
        return passed ? now + Watchdog.TICK : Math.min(Math.abs(time), now + Watchdog.TICK);
    }
}
