package steward.live;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * The replay of a match while it is written, kept in memory: a replay writer writes into it, and any number of readers
 * follow, each at its own pace. A slow reader delays neither the match nor other readers, because each has its own
 * position in the list of lines. Its size depends on the match alone, a few megabytes at most.
 *
 * <p>Thread-safe.
 */
public final class LiveRecording extends OutputStream {

    /** Returned by {@link #line} when no line has been written in time. */
    static final byte[] NOT_YET = {};

    /** How the last line of a finished match begins. */
    private static final byte[] RESULT = "{\"type\":\"result\"".getBytes(StandardCharsets.UTF_8);

    private final List<byte[]> lines = new ArrayList<>();
    private final ByteArrayOutputStream unfinished = new ByteArrayOutputStream();
    private boolean over;

    @Override
    public void write(int one) {
        write(new byte[] {(byte) one}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int from, int count) {
        int start = from;
        for (int k = from; k < from + count; k++) {
            if (bytes[k] == '\n') {
                unfinished.write(bytes, start, k - start);
                lines.add(unfinished.toByteArray());
                unfinished.reset();
                start = k + 1;
            }
        }
        unfinished.write(bytes, start, from + count - start);
        notifyAll();
    }

    /** Ends the recording: no more lines follow, with or without a result. */
    @Override
    public synchronized void close() {
        over = true;
        notifyAll();
    }

    /**
     * A line, without its line end; waits for it if it has not been written yet.
     *
     * @param number counted from 0
     * @param waitMs how long to wait at most
     * @return {@link #NOT_YET} if it was not written in time, {@code null} if it never will be
     */
    synchronized byte[] line(int number, long waitMs) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(waitMs);
        while (number >= lines.size()) {
            long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            if (over) {
                return null;
            }
            if (left <= 0) {
                return NOT_YET;
            }
            wait(left);
        }
        return lines.get(number);
    }

    /** Whether the last line is known: the result, or the last line before closing. */
    synchronized boolean isComplete() {
        return over || !lines.isEmpty() && startsWith(lines.get(lines.size() - 1), RESULT);
    }

    private static boolean startsWith(byte[] line, byte[] beginning) {
        return line.length >= beginning.length
            && Arrays.equals(line, 0, beginning.length, beginning, 0, beginning.length);
    }

    /** All complete lines so far: a replay, perhaps without its end; empty at first. */
    public synchronized byte[] replay() {
        int size = lines.stream().mapToInt(line -> line.length + 1).sum();
        byte[] all = new byte[size];
        int at = 0;
        for (byte[] line : lines) {
            System.arraycopy(line, 0, all, at, line.length);
            at += line.length + 1;
            all[at - 1] = '\n';
        }
        return all;
    }
}
