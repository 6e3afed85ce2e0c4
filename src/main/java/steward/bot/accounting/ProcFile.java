package steward.bot.accounting;

import java.io.FileInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/** Reads small files of {@code /proc} into one buffer, and numbers out of it. Not thread-safe. */
final class ProcFile {

    /** Most bytes that are read: the files are shorter, but for long lists of children. */
    private static final int SIZE = 1 << 15;

    private final byte[] bytes = new byte[SIZE];
    private int length;
    private int at;

    /** Reads a file that the kernel gives in one piece; false if it is not there (any more), or must not be read. */
    boolean read(String path) {
        return read(path, false);
    }

    /** Reads a file that may be long. */
    boolean readAll(String path) {
        return read(path, true);
    }

    private boolean read(String path, boolean toTheEnd) {
        length = 0;
        at = 0;
        try (FileInputStream file = new FileInputStream(path)) {
            int count;
            do {
                count = file.read(bytes, length, SIZE - length);
                length += Math.max(0, count);
            } while (toTheEnd && count > 0 && length < SIZE);
            return true;
        } catch (IOException gone) {
            return false;
        }
    }

    /** True if the whole file, without the end of its line, is as the pattern says. */
    boolean isMatch(Pattern pattern) {
        return pattern.matcher(new String(bytes, 0, length, StandardCharsets.ISO_8859_1).strip()).matches();
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
