package steward.bot.process;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Decides for one player between its answer and its deadline. All that matters is in one number, so that every
 * decision is one compare-and-set:
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
 * Pending is the positive time of the deadline itself, on the clock of {@link Watchdog#now}; idle is a negative
 * number, minus the time of the deadline before.
 */
final class Deadline {

    /** Whose deadline it is. */
    interface Owner {

        /** The deadline has passed, and it has won. Called on a fresh daemon thread. */
        void expired();

        /**
         * Called by the watchdog, at least every {@link Watchdog#TICK} while pending. Returns at once, with true when
         * there is nothing to wait for any more: the deadline then passes now.
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
     * From now on pending.
     *
     * @param time when it passes; {@code Long.MAX_VALUE} is never
     */
    void arm(long time) {
        state.set(time);
        watchdog.look(time);
    }

    /** Moves a pending deadline to a later time; false when it has passed before. */
    boolean postpone(long time, long later) {
        return state.compareAndSet(time, later);
    }

    /** What was to be done is done; false when the deadline has passed before, and then {@link #claim} decides. */
    boolean complete(long time) {
        return state.compareAndSet(time, -time);
    }

    /** After the deadline has passed: true when the player's thread goes on, false when it was abandoned. */
    boolean claim() {
        return state.compareAndSet(EXPIRED, NEW);
    }

    /** After the deadline has passed: true when the player's thread is given up, false when it went on before. */
    boolean abandon() {
        return state.compareAndSet(EXPIRED, ABANDONED);
    }

    boolean isExpired() {
        return state.get() == EXPIRED;
    }

    /** After the deadline has passed: when that was seen. */
    long passedAt() {
        return seen;
    }

    /** Called by the watchdog alone: decides about a pending deadline. */
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
            // No more threads: late for others is better than never for this one.
            owner.expired();
        }
    }

    /**
     * Called by the watchdog alone: when it has to look again. Between two turns that is still the deadline of the
     * turn before: the next turn's is later, and so a player that answers at once does not wake the watchdog.
     */
    long nextLook(long now) {
        long time = state.get();
        boolean passed = time == EXPIRED || Math.abs(time) <= now && time < 0;
        return passed ? now + Watchdog.TICK : Math.min(Math.abs(time), now + Watchdog.TICK);
    }
}
