package steward.json;

import java.io.InputStream;
import java.io.OutputStream;
import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectReadContext;

/**
 * One JSON parser reused for many lines, so that reading a line allocates nothing: to the parser, each line is another
 * value. After the end of the value is read, call {@link #endValue}. If anything is wrong with the line, {@link #reset}
 * must be called; a new parser should then read the line once more, because it knows the position for the message.
 *
 * <p>Caveat: a line must begin with the bracket of an object or array, in UTF-8.
 */
public final class LineParser {

    private final Feed feed = new Feed();
    private final Ignored ignored = new Ignored();
    private int rest;
    private JsonParser parser;

    public static boolean canRead(byte[] bytes, int from, int to) {
        return to - from > 1 && (bytes[from] == '{' || bytes[from] == '[') && bytes[from + 1] != 0;
    }

    /** The parser, positioned before the first token of the bytes from {@code from} to {@code to}. */
    public JsonParser begin(byte[] bytes, int from, int to) {
        feed.bytes = bytes;
        feed.at = from;
        feed.to = to;
        if (parser == null) {
            parser = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), feed);
        }
        return parser;
    }

    /** Call when the value has been read to its end. @return the number of bytes after it */
    public int endValue() {
        rest = parser.releaseBuffered(ignored) + feed.to - feed.at;
        feed.at = feed.to;
        return rest;
    }

    /** After {@link #endValue}: whether the bytes after the value are blank. */
    public boolean restIsBlank() {
        for (int k = feed.to - rest; k < feed.to; k++) {
            byte one = feed.bytes[k];
            if (one != ' ' && one != '\t' && one != '\r' && one != '\n') {
                return false;
            }
        }
        return true;
    }

    /** Call when the line was not read to its end or is not JSON: the next line gets a new parser. */
    public void reset() {
        parser = null;
    }

    /** Supplies the bytes of the line, then reports the end of the stream until the next line. */
    private static final class Feed extends InputStream {

        private byte[] bytes = {};
        private int at;
        private int to;

        @Override
        public int read() {
            return at < to ? bytes[at++] & 0xFF : -1;
        }

        @Override
        public int read(byte[] into, int from, int most) {
            if (at == to) {
                return -1;
            }
            int count = Math.min(most, to - at);
            System.arraycopy(bytes, at, into, from, count);
            at += count;
            return count;
        }
    }

    /** Discards what the parser has read beyond the value: only the count matters, the bytes are in the line. */
    private static final class Ignored extends OutputStream {

        @Override
        public void write(int one) {
            return;
        }

        @Override
        public void write(byte[] bytes, int from, int count) {
            return;
        }
    }
}
