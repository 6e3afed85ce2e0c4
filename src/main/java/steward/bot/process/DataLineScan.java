package steward.bot.process;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import steward.bot.ErrorLine;

/**
 * Scan for important lines in the part of a bot's stderr that is dropped for its length. They carry data for rating
 * tools ({@code [TDATA]}, {@code [PDATA]}, {@code [PDATA+]}), or tell why the bot failed.
 */
final class DataLineScan {

    /** Bytes that are searched. */
    static final int LOOKED_AT = 1 << 20;
    /** Bytes that are kept. */
    static final int KEPT = 4 * 1024;

    /** Lines before and behind the one that says why. */
    private static final int BEFORE = 4;
    private static final int BEHIND = 8;

    private static final List<byte[]> TAGS = List.of(ascii("[TDATA]"), ascii("[PDATA]"), ascii("[PDATA+]"));

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /** Start of the last line, if it may be a data line; otherwise {@code count}. */
    static int begunLine(byte[] bytes, int count) {
        int start = count;
        while (start > 0 && bytes[start - 1] != '\n') {
            start--;
        }
        return start < count && isData(bytes, start, count) ? start : count;
    }

    /** True if the received part of a line begins like a data line. */
    private static boolean isData(byte[] bytes, int from, int to) {
        for (byte[] tag : TAGS) {
            int same = 0;
            while (same < tag.length && from + same < to && bytes[from + same] == tag[same]) {
                same++;
            }
            if (same == Math.min(tag.length, to - from)) {
                return true;
            }
        }
        return false;
    }

    /**
     * The data lines, with their ends; the last may be incomplete.
     *
     * @param lineStart whether a line begins at {@code from}
     */
    static byte[] read(RandomAccessFile file, long from, long to, boolean lineStart) throws IOException {
        byte[] bytes = new byte[(int) Math.min(LOOKED_AT, to - from)];
        file.seek(from);
        file.readFully(bytes);
        ByteArrayOutputStream lines = new ByteArrayOutputStream();
        boolean atStart = lineStart;
        for (int start = 0; start < bytes.length;) {
            int end = start;
            while (end < bytes.length && bytes[end] != '\n') {
                end++;
            }
            int behind = Math.min(bytes.length, end + 1);
            boolean whole = end < bytes.length || from + bytes.length == to;
            if (atStart && whole && isData(bytes, start, end) && end > start && lines.size() + behind - start <= KEPT) {
                lines.write(bytes, start, behind - start);
            }
            start = behind;
            atStart = true;
        }
        return lines.toByteArray();
    }

    /**
     * The lines around the one that says why, as far as they are dropped and carry no data, with their ends.
     *
     * @param from first byte that is dropped
     * @param to   first byte behind it that is not
     * @param size of the file; of its end as much is searched as of data
     */
    static byte[] error(RandomAccessFile file, long from, long to, long size) throws IOException {
        long start = Math.max(from, size - LOOKED_AT);
        byte[] bytes = new byte[(int) Math.min(LOOKED_AT, size - start)];
        file.seek(start);
        file.readFully(bytes);
        // A character for each byte, so that places in the text are those in the file.
        List<String> lines = Arrays.asList(new String(bytes, StandardCharsets.ISO_8859_1).split("(?<=\n)"));
        int found = ErrorLine.index(lines.stream().map(String::stripTrailing).toList());
        ByteArrayOutputStream kept = new ByteArrayOutputStream();
        long at = start;
        for (int k = 0; found >= 0 && k < Math.min(found + BEHIND, lines.size()); k++) {
            byte[] line = lines.get(k).getBytes(StandardCharsets.ISO_8859_1);
            at += line.length;
            if (k >= found - BEFORE && at <= to && !isData(line, 0, line.length) && kept.size() + line.length <= KEPT) {
                kept.writeBytes(line);
            }
        }
        return kept.toByteArray();
    }
}
