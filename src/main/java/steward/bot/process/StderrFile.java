package steward.bot.process;

import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.util.concurrent.ThreadLocalRandom;
import steward.bot.ErrorLine;
import steward.bot.Utf8;
import steward.files.OutputFiles;

/**
 * A bot's stderr: an unnamed file, open in this process and in the bot. A bot can never block on it, no thread has to
 * drain it, and everything that a bot wrote before its answer is in the file when the answer is read.
 *
 * <p>The bot appends, so the file may be truncated at any time, which bounds it. A bot that opens {@code /dev/stderr}
 * again without appending truncates the file itself; its output since the last read is then found only if the length of
 * the file has changed.
 */
final class StderrFile {

    /** Bytes of one turn that are kept. */
    static final int KEPT = 16 * 1024;

    /** Of the last turn this much is from its end, in bytes: there a program says why it fails. */
    static final int KEPT_OF_END = 4 * 1024;

    /** The file is truncated after a read that left it longer than this, in bytes. */
    static final long CUT_AFTER_READING = 16L << 20;

    /** The file is truncated when it grows longer than this while the bot is computing, in bytes. */
    static final long CUT_UNREAD = 256L << 20;

    private static final FileAttribute<?>[] ONLY_MINE = OutputFiles.ownerOnly();

    private final String number;
    private final Path path;
    private final RandomAccessFile file;
    private long position;
    private long lost;
    private byte[] buffer;

    private StderrFile(String number, Path path, RandomAccessFile file) {
        this.number = number;
        this.path = path;
        this.file = file;
    }

    /**
     * A new file in the directory for temporary files, readable by this user alone.
     *
     * @throws IOException when none can be created
     */
    static StderrFile create() throws IOException {
        for (;;) {
            String number = Long.toUnsignedString(ThreadLocalRandom.current().nextLong(), 36);
            Path path = folder().resolve("steward-" + number + ".stderr");
            if (Files.exists(path)) {
                continue;
            }
            // Known before it exists: a referee that is killed in between leaves none behind.
            Sentinel.shared().watchFile(number);
            try {
                Files.createFile(path, ONLY_MINE);
                return new StderrFile(number, path, new RandomAccessFile(path.toFile(), "rw"));
            } catch (FileAlreadyExistsException e) {
                Sentinel.shared().forgetFile(number);
            } catch (IOException | RuntimeException e) {
                Sentinel.shared().forgetFile(number);
                throw e;
            }
        }
    }

    /** Returns where these files are made. */
    static Path folder() {
        return Path.of(System.getProperty("java.io.tmpdir"));
    }

    /** The file by name, for as long as it has a name. */
    File file() {
        return path.toFile();
    }

    /** Removes the name, also one that a start has made anew; the file itself is deleted with its last user. */
    void unlink() {
        try {
            Files.deleteIfExists(path);
        } catch (IOException e) {
            // The system does not delete open files: the attempt at the end will delete it.
            return;
        }
    }

    /**
     * Collects the text written since the last call: its first {@value #KEPT} bytes, a line that says how many more
     * there were, and of those the data lines that {@link DataLineScan} finds. An incomplete character is left for the
     * next call. In the last call {@value #KEPT_OF_END} of the bytes are the end of what has been written, in whole
     * lines, and before them stand the lines around the {@link ErrorLine} if they would be dropped.
     *
     * @param last whether there is no next call
     * @return {@code null} when nothing has been written
     */
    synchronized String collect(boolean last) {
        try {
            long size = file.length();
            if (size == position && lost == 0) {
                return null;
            }
            if (size < position) {
                position = 0;
            }
            String text = read(size, last);
            if (size > CUT_AFTER_READING) {
                cut();
            }
            return text;
        } catch (IOException e) {
            return "[stderr cannot be read: " + e.getMessage() + "]";
        }
    }

    private String read(long size, boolean last) throws IOException {
        if (buffer == null) {
            buffer = new byte[KEPT];
        }
        boolean withEnd = last && size - position > KEPT;
        int count = fill(position, (int) Math.min(withEnd ? KEPT - KEPT_OF_END : KEPT, size - position));
        boolean more = size - position > count;
        int whole = last && !more ? count : Utf8.wholeCharacters(buffer, 0, count);
        boolean lineStart = false;
        if (more) {
            int line = DataLineScan.begunLine(buffer, whole);
            lineStart = line < whole || whole > 0 && buffer[whole - 1] == '\n';
            whole = line;
        }
        String text = new String(buffer, 0, whole, StandardCharsets.UTF_8);
        long from = position + whole;
        long to = more ? size : from;
        String end = "";
        if (withEnd) {
            int length = fill(size - KEPT_OF_END, KEPT_OF_END);
            int start = endStart(length);
            to = size - length + start;
            end = new String(buffer, start, length - start, StandardCharsets.UTF_8);
        }
        byte[] data = more ? DataLineScan.read(file, from, to, lineStart) : new byte[0];
        byte[] why = withEnd ? DataLineScan.error(file, from, to, size) : new byte[0];
        long dropped = to - from - data.length - why.length + lost;
        position = more ? size : from;
        lost = 0;
        if (dropped > 0) {
            text += (text.isEmpty() || text.endsWith("\n") ? "" : "\n") + "[" + dropped + " more bytes dropped]\n";
        }
        text += new String(data, StandardCharsets.UTF_8) + new String(why, StandardCharsets.UTF_8) + end;
        return text.isEmpty() ? null : text;
    }

    /** Reads into the buffer; how much there was. */
    private int fill(long from, int wanted) throws IOException {
        file.seek(from);
        int count = 0;
        while (count < wanted) {
            int n = file.read(buffer, count, wanted - count);
            if (n < 0) {
                break;
            }
            count += n;
        }
        return count;
    }

    /** Returns where the first whole line in the buffer begins; where none does, the first whole character. */
    private int endStart(int length) {
        for (int i = 0; i < length - 1; i++) {
            if (buffer[i] == '\n') {
                return i + 1;
            }
        }
        int start = 0;
        while (start < length && (buffer[start] & 0xC0) == 0x80) {
            start++;
        }
        return start;
    }

    private void cut() throws IOException {
        file.setLength(0);
        position = 0;
    }

    /** Truncates a file that has grown far too long before it was read. */
    void bound() {
        try {
            if (file.length() <= CUT_UNREAD) {
                return;
            }
            synchronized (this) {
                lost += file.length() - position;
                cut();
            }
        } catch (IOException e) {
            // Closed in the meantime: nothing to bound.
            return;
        }
    }

    /** Closes the file in this process. */
    synchronized void close() {
        try {
            file.close();
        } catch (IOException e) {
            // Nothing was written through this handle, so nothing is lost.
            return;
        } finally {
            unlink();
            Sentinel.shared().forgetFile(number);
        }
    }
}
