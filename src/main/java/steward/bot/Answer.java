package steward.bot;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Reusable result of one {@link Player#ask}: the answer's bytes, or a fault, and the time. One instance is reused from
 * turn to turn, so that asking allocates nothing.
 */
public final class Answer {

    private byte[] bytes = new byte[1024];
    private int length;
    private long nanos;
    private String fault;
    private String stderr;
    private int extraLines;
    private TimeSpent timeSpent;
    private boolean held;

    public void clear() {
        length = 0;
        nanos = 0;
        fault = null;
        stderr = null;
        extraLines = 0;
        timeSpent = null;
        held = false;
    }

    /**
     * The answer's bytes, UTF-8, valid up to {@link #length()}; lines are separated by {@code '\n'}, the last has none.
     * The array is replaced when an answer outgrows it.
     */
    public byte[] bytes() {
        return bytes;
    }

    /**
     * Returns how many bytes of {@link #bytes()} count; with a fault, what had been received by then (shortened or
     * empty).
     */
    public int length() {
        return length;
    }

    /** The answer as text, for messages and tests: allocates. Bytes that are not UTF-8 become U+FFFD. */
    public String text() {
        return new String(bytes, 0, length, StandardCharsets.UTF_8);
    }

    /**
     * Time from the flushed frame to the end of the answer or to the fault, in nanoseconds; without the time in which
     * the referee did not run, where that decides.
     */
    public long nanos() {
        return nanos;
    }

    /** Returns why the player failed (limit and time waited, exit status, ...), or {@code null}. */
    public String fault() {
        return fault;
    }

    /** Returns the player's stderr up to this answer, bounded; {@code null} when nothing. */
    public String stderr() {
        return stderr;
    }

    /** Complete lines that were received beyond the answer; they wait for the next turn. */
    public int extraLines() {
        return extraLines;
    }

    /** True if the player is stopped while others are asked, from this answer on or before. */
    public boolean held() {
        return held;
    }

    public void setHeld(boolean stopped) {
        held = stopped;
    }

    /**
     * Returns where the time of a late answer went, or of one that a guest's referee counts as late; {@code null} if it
     * was not late, or the player is no process.
     */
    public TimeSpent timeSpent() {
        return timeSpent;
    }

    public void append(byte[] source, int from, int count) {
        if (length + count > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + count));
        }
        System.arraycopy(source, from, bytes, length, count);
        length += count;
    }

    public void setNanos(long value) {
        nanos = value;
    }

    public void setFault(String reason) {
        fault = reason;
    }

    public void setStderr(String text) {
        stderr = text;
    }

    public void setExtraLines(int count) {
        extraLines = count;
    }

    public void setTimeSpent(TimeSpent spent) {
        timeSpent = spent;
    }
}
