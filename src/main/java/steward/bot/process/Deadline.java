package steward.bot.process;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Deadline of one player, which decides whether the answer or the deadline came first. The whole state is one number,
 * so that every decision is one compare-and-set:
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
 * Pending is the positive time when the watchdog is to look next, on the clock of {@link Watchdog#now}; idle is minus
 * the last of these times.
 */
final class Deadline {

    /** The player that the deadline belongs to. */
    interface Owner {

        /** The deadline has passed before the answer. Called on a new daemon thread. */
        void expired();

        /**
         * Called by the watchdog at least every {@link Watchdog#TICK} while pending. Must return at once.
         *
         * @param overslept by how many nanoseconds the watchdog has woken up later than it was to
         * @return when it is to look again, or {@link QuestionClock#PASSED}: the deadline passes now
         */
        long look(long now, long overslept);
    }

    private static final long EXPIRED = Long.MIN_VALUE;
    private static final long ABANDONED = -1;
    private static final long NEW = -2;

    private final AtomicLong state = new AtomicLong(NEW);
    private final Watchdog watchdog;
    private final Owner owner;

    /** How long after the start of the last question the first look was to be. */
    private volatile long lead = Watchdog.TICK;

    Deadline(Watchdog watchdog, Owner owner) {
        this.watchdog = watchdog;
        this.owner = owner;
    }

    /**
     * Makes the deadline pending.
     *
     * @param look when the watchdog is to look for the first time; {@code Long.MAX_VALUE} is when it likes
     */
    void arm(long now, long look) {
        if (look - now != lead) {
            lead = look - now;
        }
        state.set(look);
        watchdog.look(look);
    }

    /** True if nothing is decided. */
    boolean isPending() {
        return state.get() > 0;
    }

    /** The answer is complete; false if the deadline has already passed, and then {@link #claim} decides. */
    boolean complete() {
        for (long time = state.get(); time > 0; time = state.get()) {
            if (state.compareAndSet(time, -time)) {
                return true;
            }
        }
        return false;
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

    /** Called only by the watchdog: has its owner decide about a pending deadline. */
    void check(long now, long overslept) {
        long time = state.get();
        if (time < 0) {
            return;
        }
        long next = owner.look(now, overslept);
        if (next != QuestionClock.PASSED) {
            if (next != time) {
                state.compareAndSet(time, next);
            }
            return;
        }
        if (!state.compareAndSet(time, EXPIRED)) {
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
     * Called only by the watchdog: when to check again. Between two turns that is when it would have looked at the
     * previous one, and then as long after that as it usually looks after a question: the next question's first look is
     * later, so a player that answers at once does not wake the watchdog.
     */
    long nextLook(long now) {
        long time = state.get();
        boolean passed = time == EXPIRED || Math.abs(time) <= now && time < 0;
        return passed ? now + Math.min(lead, Watchdog.TICK) : Math.min(Math.abs(time), now + Watchdog.TICK);
    }
}
