package steward.bot;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * Reader of a bot's answers, line by line, with blocking reads into one buffer. Bytes beyond an answer stay in the
 * buffer, or in the pipe, for the next turn. A byte order mark at the very beginning, as some libraries write it, is
 * skipped.
 *
 * <p>When a process exits, the JDK moves the rest of the pipe to memory. It holds the stream's monitor meanwhile, as
 * reads do: no output is lost, and the end of the stream comes after it.
 */
public final class AnswerReader {

    /** The longest line, in bytes without its line end. */
    public static final int LINE_LIMIT = 64 * 1024;

    /** Bytes that are read at once: the most that the JDK reads without a copy and without allocating. */
    private static final int READ = 8192;

    private static final byte[] NEWLINE = {'\n'};
    private static final byte[] MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};

    /** Outcome of waiting for an answer. */
    public enum Outcome {
        /** All lines were received. */
        COMPLETE,
        /** The stream ended before that. */
        ENDED,
        /** A line is longer than {@link #LINE_LIMIT}. */
        TOO_LONG
    }

    private final InputStream stream;
    private byte[] buffer = new byte[2 * READ];

    /** The bytes from start to end are unread. */
    private int start;
    private int end;

    /** Nothing has been taken yet. */
    private boolean atBeginning = true;

    /** The end of the last complete line of the answer that is being waited for. */
    private int afterLines;

    /** Complete lines received when the last read began. */
    private volatile int lines;

    public AnswerReader(InputStream stream) {
        this.stream = stream;
    }

    /** Waits for a number of lines; {@link #take} then moves them to the answer. */
    public Outcome await(int wanted) {
        int found = 0;
        int scanned = start;
        afterLines = start;
        for (;;) {
            while (found < wanted) {
                scanned = newline(buffer, scanned, end);
                if (scanned == end) {
                    break;
                }
                if (length(afterLines, scanned) > LINE_LIMIT) {
                    return Outcome.TOO_LONG;
                }
                found++;
                scanned++;
                afterLines = scanned;
            }
            if (found == wanted) {
                return Outcome.COMPLETE;
            }
            if (length(afterLines, end) > LINE_LIMIT) {
                return Outcome.TOO_LONG;
            }
            if (lines != found) {
                lines = found;
            }
            int moved = makeRoom();
            scanned -= moved;
            afterLines -= moved;
            if (!read()) {
                return Outcome.ENDED;
            }
        }
    }

    /** Returns where the next line end is, or {@code to}. A method of its own, so that the compiler optimises the loop.
     */
    private static int newline(byte[] bytes, int from, int to) {
        for (int i = from; i < to; i++) {
            if (bytes[i] == '\n') {
                return i;
            }
        }
        return to;
    }

    /** A line's bytes without the carriage return at its end. */
    private int length(int from, int to) {
        return to > from && buffer[to - 1] == '\r' ? to - from - 1 : to - from;
    }

    /**
     * Reads what is available, or waits for input. A read of more than is available asks the system twice how much
     * there is, which takes as long as the read itself. So one byte is read; a skip tells how much came with it into
     * the stream's memory; then that much is read. A skip would block only where the line is neither complete nor too
     * long, and there the read has to wait as well.
     */
    private boolean read() {
        try {
            if (!stream.markSupported()) {
                return add(stream.read(buffer, end, READ));
            }
            int first = stream.read();
            if (first < 0) {
                return false;
            }
            buffer[end++] = (byte) first;
            boolean enough = first == '\n' || end - afterLines > LINE_LIMIT;
            if (enough && stream.available() == 0) {
                return true;
            }
            stream.mark(READ);
            int more = (int) stream.skip(READ - 1);
            stream.reset();
            return more == 0 || add(stream.read(buffer, end, more));
        } catch (IOException e) {
            // As at the end of the stream: nothing more will be received.
            return false;
        }
    }

    private boolean add(int count) {
        end += Math.max(0, count);
        return count > 0;
    }

    /** Makes room for one read; returns by how much the unread bytes have moved to the front. */
    private int makeRoom() {
        if (buffer.length - end >= READ) {
            return 0;
        }
        int moved = start;
        byte[] target = end - start + READ > buffer.length ? new byte[2 * buffer.length] : buffer;
        System.arraycopy(buffer, start, target, 0, end - start);
        buffer = target;
        end -= moved;
        start = 0;
        return moved;
    }

    /** Moves the awaited lines to the answer, without carriage returns at their ends. */
    public void take(int wanted, Answer answer) {
        if (atBeginning) {
            skipMark();
        }
        for (int from = start; from < afterLines;) {
            int to = wanted == 1 ? afterLines - 1 : newline(buffer, from, afterLines);
            if (from > start) {
                answer.append(NEWLINE, 0, 1);
            }
            answer.append(buffer, from, length(from, to));
            from = to + 1;
        }
        start = afterLines;
        if (start == end) {
            start = 0;
            end = 0;
        }
    }

    private void skipMark() {
        atBeginning = false;
        if (end - start >= MARK.length && Arrays.equals(buffer, start, start + MARK.length, MARK, 0, MARK.length)) {
            start += MARK.length;
            afterLines = Math.max(start, afterLines);
        }
    }

    /** Copies what was received in place of an answer, shortened to at most {@code most} bytes. */
    public void show(Answer answer, int most) {
        if (atBeginning) {
            skipMark();
        }
        int count = Math.min(most, end - start);
        answer.append(buffer, start, count < end - start ? Utf8.wholeCharacters(buffer, start, count) : count);
    }

    /** Complete lines received of an incomplete answer; any thread may call this. */
    public int linesReceived() {
        return lines;
    }

    /** Bytes received after the last complete line of the answer. */
    public int partialBytes() {
        return end - afterLines;
    }

    /** Further complete lines that have been read. */
    public int extraLines() {
        int count = 0;
        for (int i = newline(buffer, start, end); i < end; i = newline(buffer, i + 1, end)) {
            count++;
        }
        return count;
    }

    public void close() {
        try {
            stream.close();
        } catch (IOException e) {
            // No further input is needed.
            return;
        }
    }
}
