package steward.bot.accounting;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Reader of small files of {@code /proc} into one buffer, and of the numbers in them. Not thread-safe.
 *
 * <p>A reader that {@linkplain #keep keeps} its files open reads each again from its beginning, in less than half the
 * time, since no path is looked up. The open file of a process that has ended is never that of a later process with the
 * same number.
 */
final class ProcFile implements AutoCloseable {

    /** Most files that are kept open; those of bots with more processes and threads are opened each time. */
    private static final int MOST_KEPT = 64;

    /** Most bytes that are read: the files are shorter, but for long lists of children. */
    private static final int SIZE = 1 << 15;
    /** Most bytes of one call: for more, the JDK allocates memory. */
    private static final int PIECE = 1 << 13;

    private final byte[] bytes = new byte[SIZE];
    private int length;
    private int at;
    private Map<String, RandomAccessFile> kept;

    /** @param open true if files stay open from now on, until {@link #close} */
    void keep(boolean open) {
        kept = open ? new HashMap<>() : null;
    }

    /** Closes the files that are kept, and keeps none from now on. */
    @Override
    public void close() {
        if (kept != null) {
            kept.values().forEach(ProcFile::close);
            kept = null;
        }
    }

    private static void close(RandomAccessFile file) {
        try {
            file.close();
        } catch (IOException neverOfFilesThatAreRead) {
            throw new UncheckedIOException(neverOfFilesThatAreRead);
        }
    }

    /** Reads a file that the kernel gives in one piece; false if it is not there (any more), or must not be read. */
    boolean read(String path) {
        return read(path, false);
    }

    /** Reads a file that may be long. */
    boolean readAll(String path) {
        return read(path, true);
    }

    private boolean read(String path, boolean toTheEnd) {
        RandomAccessFile again = kept == null ? null : kept.get(path);
        try {
            if (again != null) {
                again.seek(0);
                fill(again, toTheEnd);
                return true;
            }
        } catch (IOException gone) {
            kept.remove(path);
            close(again);                              // its number may be that of another process by now
        }
        try {
            RandomAccessFile file = new RandomAccessFile(path, "r");
            if (kept != null && kept.size() < MOST_KEPT) {
                kept.put(path, file);
                fill(file, toTheEnd);
            } else {
                try (file) {
                    fill(file, toTheEnd);
                }
            }
            return true;
        } catch (IOException gone) {
            length = 0;
            return false;
        }
    }

    private void fill(RandomAccessFile file, boolean toTheEnd) throws IOException {
        length = 0;
        at = 0;
        int count;
        do {
            count = file.read(bytes, length, Math.min(PIECE, SIZE - length));
            length += Math.max(0, count);
        } while (toTheEnd && count > 0 && length < SIZE);
    }

    /** True if the whole file, without the end of its line, is as the pattern says. */
    boolean isMatch(Pattern pattern) {
        return pattern.matcher(new String(bytes, 0, length, StandardCharsets.ISO_8859_1).strip()).matches();
    }

    /** Goes behind the first occurrence of a word; false if there is none. */
    boolean skipPast(String word) {
        int found = new String(bytes, 0, length, StandardCharsets.ISO_8859_1).indexOf(word);
        at = found + word.length();
        return found >= 0;
    }

    /** Goes behind the last closing bracket: the name of a program, in brackets, may hold anything. */
    boolean skipName() {
        for (int k = length - 1; k >= 0; k--) {
            if (bytes[k] == ')') {
                at = k + 1;
                return true;
            }
        }
        return false;
    }

    /** The first character of the next word; 0 at the end. */
    char nextCharacter() {
        skipSpace();
        char first = at < length ? (char) bytes[at] : 0;
        skipWord();
        return first;
    }

    /** Passes over words. */
    void skipWords(int count) {
        for (int k = 0; k < count; k++) {
            skipSpace();
            skipWord();
        }
    }

    /** True if there is a further word. */
    boolean hasNext() {
        skipSpace();
        return at < length;
    }

    /** The next word as a whole number, as far as it is one. */
    long nextLong() {
        skipSpace();
        long value = 0;
        while (at < length && bytes[at] >= '0' && bytes[at] <= '9') {
            value = 10 * value + bytes[at++] - '0';
        }
        skipWord();
        return value;
    }

    /** The next word as a number with two decimals, in hundredths. */
    long nextHundredths() {
        skipSpace();
        long value = 0;
        for (; at < length && bytes[at] > ' '; at++) {
            value = bytes[at] == '.' ? value : 10 * value + bytes[at] - '0';
        }
        return value;
    }

    private void skipSpace() {
        while (at < length && bytes[at] <= ' ') {
            at++;
        }
    }

    private void skipWord() {
        while (at < length && bytes[at] > ' ') {
            at++;
        }
    }
}
