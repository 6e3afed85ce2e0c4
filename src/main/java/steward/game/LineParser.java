package steward.game;

import java.io.InputStream;
import java.io.OutputStream;
import steward.Internal;
import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectReadContext;

/**
 * One JSON parser for many lines, so that reading a line allocates nothing: each line is one more value to it. A line
 * is read to the end of its value, and {@link #rest} called; if anything about it is wrong, {@link #forget} must be
 * called, and the line is best read once more by a parser of its own, which knows the place for the message.
 *
 * <p>Caveat: a line must begin with the bracket of an object or array, in UTF-8.
 */
@Internal
public final class LineParser {

    private final Feed feed = new Feed();
    private final Ignored ignored = new Ignored();
    private int rest;
    private JsonParser parser;

    /** Whether a line can be read here at all. */
    public static boolean canRead(byte[] bytes, int from, int to) {
        return to - from > 1 && (bytes[from] == '{' || bytes[from] == '[') && bytes[from + 1] != 0;
    }

    /** A parser that stands before the first token of the bytes from {@code from} to {@code to}. */
    public JsonParser begin(byte[] bytes, int from, int to) {
        feed.bytes = bytes;
        feed.at = from;
        feed.to = to;
        if (parser == null) {
            parser = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), feed);
        }
        return parser;
    }

    /** The value has been read to its end: how many bytes there are behind it. */
    public int rest() {
        rest = parser.releaseBuffered(ignored) + feed.to - feed.at;
        feed.at = feed.to;
        return rest;
    }

    /** After {@link #rest}: whether all that was behind the value is blank. */
    public boolean restIsBlank() {
        for (int k = feed.to - rest; k < feed.to; k++) {
            byte one = feed.bytes[k];
            if (one != ' ' && one != '\t' && one != '\r' && one != '\n') {
                return false;
            }
        }
        return true;
    }

    /** The line was not read to its end, or is no JSON: the parser cannot be used for another. */
    public void forget() {
        parser = null;
    }

    /** Gives the bytes of the line, then seems to be at its end until there is another. */
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

    /** What the parser had read beyond the value; it is counted, and stands in the line anyhow. */
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
