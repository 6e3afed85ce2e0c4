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
 * follow, each at its own pace. A reader that is slow holds nobody up, since it waits on nothing but its own place in
 * the list of lines. It grows with the match alone, which is a few megabytes at most, whoever reads.
 *
 * <p>Thread-safe.
 */
public final class LiveRecording extends OutputStream {

    /** What {@link #line} gives when no line has come in time. */
    static final byte[] NOT_YET = {};

    /** How the last line of a match that came to its end begins; a signature comes in one piece with a result. */
    private static final byte[] RESULT = "{\"type\":\"result\"".getBytes(StandardCharsets.UTF_8);
    private static final byte[] SIGNATURE = "{\"type\":\"signature\"".getBytes(StandardCharsets.UTF_8);

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

    /** No more lines will come, with or without a result. */
    @Override
    public synchronized void close() {
        over = true;
        notifyAll();
    }

    /**
     * A line, without its end; waits for it if it has not been written yet.
     *
     * @param number counted from 0
     * @param waitMs how long to wait at most
     * @return {@link #NOT_YET} if it has not come in time, {@code null} if it never will
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

    /** Whether the last line is there: the result, or whichever was the last when it was closed. */
    synchronized boolean isComplete() {
        byte[] last = lines.isEmpty() ? NOT_YET : lines.get(lines.size() - 1);
        return over || startsWith(last, RESULT) || startsWith(last, SIGNATURE);
    }

    private static boolean startsWith(byte[] line, byte[] beginning) {
        return line.length >= beginning.length
            && Arrays.equals(line, 0, beginning.length, beginning, 0, beginning.length);
    }

    /** Everything that has been written in whole lines so far: a replay, perhaps without its end; empty at first. */
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
