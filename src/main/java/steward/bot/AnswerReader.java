package steward.bot;

import java.io.IOException;
import java.io.InputStream;
import steward.Internal;

/**
 * Reads a bot's answers, line by line, with blocking reads into one buffer. What comes beyond an answer stays here,
 * or in the pipe, for the next turn.
 *
 * <p>When a process exits, the JDK moves what is left in the pipe to memory. It does so holding the stream's monitor,
 * as reads do: nothing that was written is lost, and the end of the stream comes after it.
 */
@Internal
public final class AnswerReader {

    /** The longest line, in bytes without its line end. */
    public static final int LINE_LIMIT = 64 * 1024;

    /** How much is read at once, in bytes: what the JDK reads without a copy and without allocating. */
    private static final int READ = 8192;

    private static final byte[] NEWLINE = {'\n'};

    /** How waiting for an answer ended. */
    public enum Outcome {
        /** The lines are there. */
        COMPLETE,
        /** The stream ended before. */
        ENDED,
        /** A line is longer than {@link #LINE_LIMIT}. */
        TOO_LONG
    }

    private final InputStream stream;
    private byte[] buffer = new byte[2 * READ];

    /** The bytes from start to end are unread. */
    private int start;
    private int end;

    /** The end of the last complete line of the answer that is being waited for. */
    private int afterLines;

    /** How many lines had come when the last read began. */
    private volatile int lines;

    public AnswerReader(InputStream stream) {
        this.stream = stream;
    }

    /** Waits until so many lines have come, of which {@link #take} can then be called. */
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

    /** Where the next line end is, or {@code to}. A loop of its own, for the compiler's sake. */
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
     * Reads what is there, or waits for something. A read of more than is there asks the system how much that is, twice
     * over, which takes as long as the read itself: so we read one byte, find out by skipping how much has come with
     * it into the stream's memory, and read that. Where a skip would wait, the line is neither complete nor too long,
     * and so do we.
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
            // The same to us: nothing more will come.
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

    /** Moves the lines that were waited for to the answer, without carriage returns at their ends. */
    public void take(int wanted, Answer answer) {
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

    /** Shows what came in place of an answer, shortened to at most so many bytes. */
    public void show(Answer answer, int most) {
        int count = Math.min(most, end - start);
        answer.append(buffer, start, count < end - start ? Utf8.wholeCharacters(buffer, start, count) : count);
    }

    /** How many lines of an incomplete answer have come; may be asked by any thread. */
    public int come() {
        return lines;
    }

    /** How many bytes have come after the last complete line of the answer. */
    public int loose() {
        return end - afterLines;
    }

    /** How many further complete lines have been read. */
    public int extra() {
        int count = 0;
        for (int i = newline(buffer, start, end); i < end; i = newline(buffer, i + 1, end)) {
            count++;
        }
        return count;
    }

    /** Closes the stream. */
    public void close() {
        try {
            stream.close();
        } catch (IOException e) {
            // Nothing more is wanted from it.
            return;
        }
    }
}
