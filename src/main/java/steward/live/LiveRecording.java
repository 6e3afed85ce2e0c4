package steward.live;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Replay of a match in memory while it is written, for any number of readers. A slow reader delays neither the match
 * nor other readers, because each has its own position in the shared list of lines. Its size depends on the match
 * alone, a few megabytes at most.
 *
 * <p>Thread-safe.
 */
public final class LiveRecording extends OutputStream implements LiveFeed {

    private static final byte[] DATA = Answers.bytes("data: ");
    private static final int BEFORE = DATA.length;
    private static final byte[] NOTHING = {};

    /** How the last line of a finished match begins; a signature is written together with a result. */
    private static final byte[] RESULT = "{\"type\":\"result\"".getBytes(StandardCharsets.UTF_8);
    private static final byte[] SIGNATURE = "{\"type\":\"signature\"".getBytes(StandardCharsets.UTF_8);

    /** Each as the event that tells of it. */
    private final List<byte[]> lines = new ArrayList<>();
    private final ByteArrayOutputStream unfinished = new ByteArrayOutputStream();
    private volatile Runnable changed = () -> { };
    private boolean over;

    /** Nothing is written yet. */
    public LiveRecording() {
        unfinished.writeBytes(DATA);
    }

    @Override
    public void write(int one) {
        write(new byte[] {(byte) one}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int from, int count) {
        int start = from;
        for (int k = from; k < from + count; k++) {
            if (bytes[k] == '\n') {
                unfinished.write(bytes, start, k + 1 - start);
                unfinished.write('\n');
                lines.add(unfinished.toByteArray());
                unfinished.reset();
                unfinished.writeBytes(DATA);
                start = k + 1;
            }
        }
        unfinished.write(bytes, start, from + count - start);
        changed.run();
    }

    /** Forgets what is written, for a match that begins anew; there are no readers yet. */
    public synchronized void clear() {
        lines.clear();
        unfinished.reset();
        unfinished.writeBytes(DATA);
    }

    /** Ends the recording: no more lines follow, with or without a result. */
    @Override
    public synchronized void close() {
        over = true;
        changed.run();
    }

    @Override
    public synchronized Piece piece(long position) {
        return position < lines.size() ? new Piece(lines.get((int) position), position + 1) : over ? END : null;
    }

    @Override
    public void onChange(Runnable listener) {
        changed = listener;
    }

    /** True if the last line is known: the result, or the last line before closing. */
    @Override
    public synchronized boolean isComplete() {
        byte[] last = lines.isEmpty() ? NOTHING : lines.get(lines.size() - 1);
        return over || startsWith(last, RESULT) || startsWith(last, SIGNATURE);
    }

    private static boolean startsWith(byte[] line, byte[] beginning) {
        return line.length >= BEFORE + beginning.length
            && Arrays.equals(line, BEFORE, BEFORE + beginning.length, beginning, 0, beginning.length);
    }

    /** All complete lines so far: a replay, perhaps without its end; empty at first. */
    public synchronized byte[] replay() {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] line : lines) {
            all.write(line, BEFORE, line.length - BEFORE - 1);           // with the first of its two line ends
        }
        return all.toByteArray();
    }
}
