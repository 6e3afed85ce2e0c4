package steward.bot;

import java.util.function.Consumer;
import steward.Internal;

/**
 * Player of one match as the referee sees it: receives lines and is asked for lines. Not thread-safe: one thread at a
 * time uses a player and hands it over with a happens-before edge. Only {@link #finish} may be called by any thread at
 * any time, to break a match off: an {@link #ask} in progress then ends with a fault, unless the player runs on the
 * asking thread.
 */
public interface Player extends AutoCloseable {

    /** Ending of a call to {@link #ask}. */
    enum Ending {
        /** The answer is complete; {@link Answer#length()} bytes are there. */
        ANSWERED,
        /** The player failed; {@link Answer#fault()} says how. The player must not be asked again. */
        FAULT,
        /**
         * The call was abandoned because it could not be unblocked: another thread has already been given the fault
         * (see {@link #onAbandoned}) and owns the match now. The caller must return at once and change nothing.
         */
        ABANDONED
    }

    /** The name shown to people and kept in the replay. */
    String name();

    /** True if {@link #ask} may block its thread, so that a match needs a thread of its own. By default it may. */
    @Internal
    default boolean mayBlock() {
        return true;
    }

    /**
     * Says what the limits of {@link #ask} are limits of; to be called before the first. By default this does nothing,
     * and they are limits of the wall clock.
     */
    default void limitBy(TimeBasis basis) {
        return;
    }

    /**
     * Says after which time the next answers count as late although they are within the limit, in nanoseconds: then
     * {@link Answer#timeSpent} has where the time went. By default this does nothing.
     */
    default void strikeAfter(long nanos) {
        return;
    }

    /**
     * Queues lines that need no answer (the setup frame). They reach the player at the latest with the next
     * {@link #ask}; the bytes are copied. By default they are dropped.
     */
    default void tell(byte[] lines, int length) {
        return;
    }

    /**
     * Sends the lines and waits for the answer. The clock runs from the flushed frame to the end of the last answer
     * line; the first call starts a process and writes at once, so that its start is included.
     *
     * @param frame       the lines to send, each with its line end
     * @param length      how many bytes of {@code frame} count
     * @param answerLines how many lines make an answer, at least 1
     * @param limitNanos  the deadline, in nanoseconds after the flush, or as {@link #limitBy} says;
     *                    {@code Long.MAX_VALUE} is no deadline
     * @param answer      receives the answer, the time it took and what the player wrote to its stderr meanwhile
     */
    Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer);

    /**
     * Registers the continuation for an {@link #ask} that has to be abandoned together with the thread blocked in it.
     * It is called on a new daemon thread with the fault filled in, at most once per ask. By default this does nothing:
     * the call always returns.
     */
    default void onAbandoned(Consumer<Answer> continuation) {
        return;
    }

    /**
     * Starts to send the last lines before {@link #finish}, so that several players can end at the same time. Returns
     * at once; {@code finish} does the rest and is to be called next with the same lines. By default this does nothing.
     *
     * @param lines the end frame; the bytes are copied
     */
    default void sendLastLines(byte[] lines, int length) {
        return;
    }

    /**
     * Ends the match for this player: sends the last lines if that is possible without waiting, closes its input, gives
     * it a short time to exit by itself, then kills whatever is left of it. The second call does nothing. Never blocks
     * for long, never throws. By default there is nothing to end.
     *
     * @param lines the end frame, or {@code null} if there is none
     */
    default void finish(byte[] lines, int length) {
        return;
    }

    /**
     * Returns the player's stderr after its last answer, bounded; {@code null} when nothing. Known once {@link #finish}
     * has returned.
     */
    default String finalStderr() {
        return null;
    }

    /**
     * Processor time of the player while another was asked who was late.
     *
     * @param sinceNanos how long ago that question began
     * @return its place in the game left open; {@code null} if it did not burn, or was held by then, or it is not known
     */
    @Internal
    default Burner burner(long sinceNanos) {
        return null;
    }

    /** Calls {@code finish(null, 0)}. */
    @Override
    default void close() {
        finish(null, 0);
    }
}
