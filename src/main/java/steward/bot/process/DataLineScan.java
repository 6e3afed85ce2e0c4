package steward.bot.process;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
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

    private static final List<String> TAGS = List.of("[TDATA]", "[PDATA]", "[PDATA+]");

    /** Start of the last line, if it may be a data line; otherwise {@code count}. */
    static int begunLine(byte[] bytes, int count) {
        int start = count;
        while (start > 0 && bytes[start - 1] != '\n') {
            start--;
        }
        return start < count && isData(text(bytes, start, count)) ? start : count;
    }

    /** True if the received part of a line begins like a data line. */
    private static boolean isData(String line) {
        return TAGS.stream().anyMatch(tag -> line.startsWith(tag) || tag.startsWith(line));
    }

    /** A character for each byte, so that places in the text are those in the file. */
    private static String text(byte[] bytes, int from, int to) {
        return new String(bytes, from, to - from, StandardCharsets.ISO_8859_1);
    }

    private static String[] lines(RandomAccessFile file, long from, long to) throws IOException {
        byte[] bytes = new byte[(int) Math.min(LOOKED_AT, to - from)];
        file.seek(from);
        file.readFully(bytes);
        return text(bytes, 0, bytes.length).split("(?<=\n)");
    }

    /**
     * The data lines, with their ends; the last may be incomplete.
     *
     * @param lineStart whether a line begins at {@code from}
     */
    static byte[] read(RandomAccessFile file, long from, long to, boolean lineStart) throws IOException {
        StringBuilder kept = new StringBuilder();
        boolean atStart = lineStart;
        for (String line : lines(file, from, to)) {
            boolean whole = line.endsWith("\n") || to - from <= LOOKED_AT;
            String plain = line.replace("\n", "");
            if (atStart && whole && !plain.isEmpty() && isData(plain) && kept.length() + line.length() <= KEPT) {
                kept.append(line);
            }
            atStart = true;
        }
        return kept.toString().getBytes(StandardCharsets.ISO_8859_1);
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
        List<String> lines = List.of(lines(file, start, size));
        int found = ErrorLine.index(lines.stream().map(String::stripTrailing).toList());
        StringBuilder kept = new StringBuilder();
        long at = start;
        for (int k = 0; found >= 0 && k < Math.min(found + BEHIND, lines.size()); k++) {
            String line = lines.get(k);
            at += line.length();
            if (k >= found - BEFORE && at <= to && !isData(line) && kept.length() + line.length() <= KEPT) {
                kept.append(line);
            }
        }
        return kept.toString().getBytes(StandardCharsets.ISO_8859_1);
    }
}
